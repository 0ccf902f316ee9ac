"""What people see of a training run beside its logs.

loggers.py   TensorBoard, Weights & Biases and CSV, through stable-baselines3's own logger
page.py      the report as a page for the browser
"""
