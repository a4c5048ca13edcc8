"""A substitution without a value."""


class SubstitutionFailure(RuntimeError):
    """A substitution could not be evaluated."""
