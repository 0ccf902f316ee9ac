"""The physical field: bodies, drive and ball, and the pymunk engine behind them."""
