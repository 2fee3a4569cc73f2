"""`python -m unity_link`: the command line, for environments in which the command is not on the path."""

from unity_link.cli import main

if __name__ == "__main__":
    main()
