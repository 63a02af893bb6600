"""What peers/build.py is made of: from a peer's description to its plug-in."""
