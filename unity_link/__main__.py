"""`python -m unity_link`: the command line, where the command itself is not on the path."""

from unity_link.cli import main

if __name__ == "__main__":
    main()
