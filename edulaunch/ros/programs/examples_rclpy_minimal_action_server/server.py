"""The program server: it executes all its goals at the same time."""

from __future__ import annotations

from examples_rclpy_minimal_action_server._fibonacci import MinimalActionServer, serve


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    serve(MinimalActionServer, args)


if __name__ == '__main__':
    main()
