"""The exceptions and warnings of the package: each says what is wrong, where, and what to do."""

from sklearn.exceptions import DataConversionWarning


class Error(Exception):
    """A failure with an external cause.

    Attributes:
        what: What is wrong.
        where: The file, argument or row, or an empty text.
        advice: What to do, or an empty text.
    """

    def __init__(self, what, where="", advice=""):
        super().__init__(what, where, advice)
        self.what = what
        self.where = where
        self.advice = advice

    def __str__(self):
        place = f"{self.where}: " if self.where else ""
        advice = f"; {self.advice}" if self.advice else ""
        return f"{place}{self.what}{advice}"


class UsageError(Error, ValueError):
    """An argument or a key of a file is wrong."""


class DataError(Error, ValueError):
    """The content of a file, a recording or an array cannot be used."""


class OperatingSystemError(Error):
    """The operating system reports an error, or memory does not suffice."""


class LeftOutWarning(UserWarning):
    """Parts of a data set are not in the recording, such as pictures; the message names them."""


class ConversionWarning(DataConversionWarning):
    """Many rows were copied in order to convert them; reported once for each reason in a process."""
