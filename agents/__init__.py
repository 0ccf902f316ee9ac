"""Play learned teams: networks, policy files and the bundled policies.

learned.py      a policy as a team
policy.py       what a policy is: a network and all that has to agree before it may play
rules_known.py  the rules it was trained under, and a warning where it plays under others
policy_file.py  policy files, which never run code
sb3_zip.py      zips of stable-baselines3, read without running what is in them
perceptron.py   the network, computed in compiled code
attention.py    attention over other players, before its layers
policies/       the bundled policies, with their page
"""
