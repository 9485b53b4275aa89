"""What users pass: rows, labels, layers and numbers in any form, as the library takes them."""
