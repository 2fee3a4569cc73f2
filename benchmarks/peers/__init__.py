"""Unity-Link compared with its peers, each on its own medium, in one run: `make bench-peers`, part of `make bench`."""
