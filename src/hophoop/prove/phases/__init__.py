"""Rolling, slip and flight up to their next event, and what a certificate records of them."""
