"""Pages of the site that are made from the package itself, whenever the site is built.

reference.py    the public names in the order of what is done with them
catalogue.py    what there is to choose from: observations, actions, rewards, scenes and so on
commands.py     every command with its options
examples.py     the examples of `train/examples/` with their code
markdown.py     tables
"""
