"""The exceptions and warnings of the package: each says what is wrong, where, and what to do."""

from contextlib import contextmanager

from sklearn import exceptions


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


class DataTypeError(DataError, TypeError):
    """An argument is of a type that cannot be used, such as a text instead of numbers."""


class MissingChannelError(UsageError, KeyError):
    """A frame lacks a channel of a system."""


class NotFittedError(UsageError, exceptions.NotFittedError):
    """An estimator is used before it is trained."""


class OperatingSystemError(Error):
    """The operating system reports an error, or memory does not suffice."""


class LeftOutWarning(UserWarning):
    """Parts of a data set are not in the recording, such as pictures; the message names them."""


class LabelWarning(UserWarning):
    """Labels may not mean what they seem to; the message says why."""


class PrecisionWarning(UserWarning):
    """float32 holds the values of a column only coarsely; the message says what is lost."""


class SettingsWarning(UserWarning):
    """Settings that are not given have defaults, which are not those of the data; the message says
    what to give."""


class ConversionWarning(exceptions.DataConversionWarning):
    """Many rows were copied in order to convert them; reported once for each reason in a process."""


@contextmanager
def errors_of_sklearn(where, advice):
    """Errors of checks of scikit-learn become errors of the package, with the same text."""
    try:
        yield
    except Error:
        raise
    except TypeError as error:
        raise DataTypeError(str(error), where, advice) from error
    except (ValueError, RuntimeError) as error:
        raise DataError(str(error), where, advice) from error
