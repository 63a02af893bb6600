"""Errors for invalid arguments. Each is a ValueError, and also what Python itself raises in such a case."""


class UnknownArgument(TypeError, ValueError):
    """A keyword that the function or the solver does not have."""


class NotInMesh(IndexError, ValueError):
    """The index of a vertex or a face that the mesh does not have."""
