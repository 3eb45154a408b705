"""What is raised when the input cannot be measured."""


class AmrError(ValueError):
    """Input that no metric can be computed from.

    The message says which argument it is, what was found, what was expected,
    and what to do.
    """


class RecordingWarning(UserWarning):
    """A file was not quite in its format, and was read all the same.

    The message says what was repaired or left out, how often, and where first.
    """


class DegenerateAlignmentError(AmrError):
    """The positions do not determine the alignment.

    Attributes
    ----------
    motion : str
        The motion that the data leave open, for example
        ``"the rotation about the line of travel"``.
    """

    def __init__(self, message, motion):
        super().__init__(message)
        self.motion = motion

    def __reduce__(self):
        # The default rebuilds an exception from its message alone, which fails
        # when a worker process sends this one back.
        return type(self), (self.args[0], self.motion)
