"""Parts of the class SOM, by what they do with a trained map."""
