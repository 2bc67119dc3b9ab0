"""Where a function of one variable goes from negative to positive."""


def sign_change(of, low, high, accuracy):
    """The argument between `low`, where it is negative, and `high`, where it is not, by bisection."""
    while high - low > accuracy:
        middle = (low + high) / 2
        low, high = (middle, high) if of(middle) < 0 else (low, middle)
    return (low + high) / 2
