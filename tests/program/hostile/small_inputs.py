"""Inputs of which a training takes milliseconds."""

STUDY = """[study]
name = "small"
label = "object"
seeds = 1
[module.joints]
type = "channel"
channel = "joints"
[module.closed]
type = "last"
input = "joints"
[module.map]
type = "som"
input = "closed"
rows = 3
columns = 3
iterations = 100
"""
ROWS = "".join(f"{i % 3}.5,{i * i % 7},{i}\n" for i in range(24))
