"""Files of maps, and maps of other programs."""

import os
import warnings
from typing import TypeVar

import numpy as np

from .. import _somato
from .._inputs.rows import check_fitted, level_of_user
from ..errors import LeftOutWarning, UsageError
from .foreign import parts_of_minisom, weights_of


Estimator = TypeVar("Estimator", bound="MapFiles")


class MapFiles:
    """The files of ``SOM``, and the maps that it takes over; its methods are these."""

    def save(self, path) -> None:
        """Writes the map to a model file, which ``somato som map`` reads as well."""
        check_fitted(self, "map_")
        self.map_.save(os.fspath(path))

    def export(self, path) -> None:
        """Writes the map to an NPZ archive, which ``numpy.load`` opens without pickle.

        ``SOM.load`` and ``somato som import`` read the same map from it. docs/formats/map-npz.md
        describes its arrays.

        Raises:
            DataError: The weights need 4 GiB or more.
        """
        check_fitted(self, "map_")
        self.map_.export_npz(os.fspath(path))

    @classmethod
    def load(cls: type[Estimator], path, *, features=None, variable=None, **parameters) -> Estimator:
        """The estimator of a map in a file.

        Args:
            path: A model file of ``save`` or ``somato som train``, an archive of ``export``, a codebook
                of SOM_PAK or SOM Toolbox (``.cod``), or weights of (rows, columns, features) or
                (neurons, features) in a file of ``numpy.save`` or ``numpy.savez``.
            features: Names of the columns, for an array.
            variable: The array of an archive of ``numpy.savez`` with several.
            **parameters: Parameters that an array or a codebook does not contain: ``lattice``,
                ``topology``, ``similarity``, ``rows`` and ``columns`` of (neurons, features), ...

        Raises:
            OperatingSystemError: The file cannot be read.
            DataError: It is damaged, or contains no map.
            UsageError: An argument does not fit the file, or has no effect.

        Warns:
            LeftOutWarning: The map does not contain everything that is in the file.
        """
        if "layers" in parameters:
            raise UsageError("a map in a file is not divided into layers afterwards", "SOM.load(layers)",
                             "pass its array to SOM.from_weights")
        trained, notes = _somato.Map.imported(os.fspath(path), parameters,
                                              [str(name) for name in features or ()], variable or "")
        for note in notes:
            warnings.warn(f"{path}: {note}", LeftOutWarning, stacklevel=level_of_user())
        return cls._of(trained)

    @classmethod
    def from_weights(cls: type[Estimator], weights, *, lattice="rectangular", topology="plane", features=None,
                     **parameters) -> Estimator:
        """The estimator of a map that was trained elsewhere.

        Args:
            weights: Numbers of (rows, columns, features); or of (neurons, features), row by row, with
                ``rows`` or ``columns`` as a parameter. A DataFrame of the latter has names.
            lattice: Its lattice. Odd rows of a hexagonal one are shifted to the right.
            topology: Its topology.
            features: Names of the features, or None.
            **parameters: Further parameters of ``SOM``, such as ``similarity``.

        Raises:
            DataError: The weights are no such array, not finite, or float32 does not hold what differs.
            UsageError: The parameters contradict the array or each other.
        """
        som = cls(lattice=lattice, topology=topology, **parameters)
        numbers, shape, names = weights_of(weights)
        names = names if features is None else [str(name) for name in features]
        found = cls._of(_somato.Map.of_weights(som._map_parameters(), numbers, shape, names))
        return found.set_params(**{name: value for name, value in som.get_params(deep=False).items()
                                   if name in cls._NOT_OF_MAP and name not in ("random_state", "seed")})

    @classmethod
    def from_minisom(cls: type[Estimator], minisom, *, similarity=None, features=None) -> Estimator:
        """The estimator of a map of the package MiniSom, which need not be installed.

        Weights, lattice and the distance that chooses winners are taken over, the parameters of its
        training are not. The first side of a rectangular map, x, becomes the rows, so that ``divmod`` of
        a winner's number by ``columns`` is MiniSom's pair. On a hexagonal lattice MiniSom shifts lines
        of equal y; these become the rows, with the last line first if there is an even number of them.

        Args:
            minisom: A ``MiniSom``.
            similarity: Instead of its distance, which is found by comparing some values of
                ``activate``.
            features: Names of the features, or None.

        Raises:
            UsageError: Its distance has no equivalent here: a function, or the signed maximum that
                MiniSom 2.3 computes for ``chebyshev``.
            DataError: As for ``from_weights``.
        """
        weights, lattice, similarity = parts_of_minisom(minisom, similarity)
        return cls.from_weights(weights, lattice=lattice, similarity=similarity, features=features)

    @classmethod
    def _of(cls, trained):
        """The estimator of a map of the library."""
        parameters = trained.parameters
        som = cls(random_state=parameters.pop("seed"), **parameters)
        som.layers = {name: tuple(how) for name, *how in trained.layers} or None
        som.map_ = trained
        som.n_features_in_ = trained.input_size
        if trained.features:
            som.feature_names_in_ = np.array(trained.features, dtype=object)
        if trained.class_names:
            som.classes_ = np.array(trained.class_names)
        return som

    @classmethod
    def _of_samples(cls, trained, winners, names, classes):
        """The same with the winners of samples and the numbers of their classes."""
        som = cls._of(trained.labelled(names, winners, classes))
        neurons = som.map_.parameters["rows"] * som.map_.parameters["columns"]
        som.hits_ = np.bincount(winners, minlength=neurons)
        som.winners_ = winners
        som._classes_of_samples = classes
        return som
