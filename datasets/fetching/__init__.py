"""The parts of datasets/fetch.py: the manifest, the cache, and the origins of meshes."""
