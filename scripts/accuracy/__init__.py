"""Parts of scripts/accuracy_study.py: data sets, folds, methods and stored cells."""
