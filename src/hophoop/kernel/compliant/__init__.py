"""The hoop on a compliant contact: a stiff equation of motion, solved implicitly step by step."""
