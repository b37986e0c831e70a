"""Tables of facts for all other packages: parameters, names of what the kernel numbers, quantities, colours."""
