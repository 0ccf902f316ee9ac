"""Pages of the site that are made from the package itself, whenever the site is built.

reference.py    the public names by task
catalogue.py    all available names: observations, actions, rewards, scenes and so on
commands.py     every command with its options
examples.py     the examples of `train/examples/` with their code
notebooks.py    the pages that have a notebook, with its outputs
markdown.py     tables
"""
