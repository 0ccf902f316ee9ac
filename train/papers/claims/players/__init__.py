"""How legged robots recognise other players, and remember them."""
