"""Tables, figures and the report of a run, drawn from its files."""
