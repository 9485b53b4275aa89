"""Readers of data sets in the layouts of other packages."""
