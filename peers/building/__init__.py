"""The parts of peers/build.py, which builds a plug-in from the description of a peer."""
