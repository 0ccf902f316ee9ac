"""Optional reports of a training run in addition to its own log.

tally.py     what matches pay and count, for the log
loggers.py   TensorBoard, Weights & Biases and CSV, through stable-baselines3's own logger
page.py      the report as a page for the browser
"""
