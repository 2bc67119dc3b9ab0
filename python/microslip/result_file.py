"""Reads the HDF5 files that microslip writes; whatever is missing or malformed is named in a ResultError."""

import contextlib
import os

import h5py
import numpy as np


class ResultError(Exception):
    """A result file that cannot be drawn; the text is one line for the user."""


#: The format of result files that this version reads; files without the attribute are taken for it.
FORMAT = "2"
DAMAGED = "cut short or damaged: copy it again, or write it again by the command that made it"


def _decoded(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


class ResultFile:
    """An open result file. Use as a context manager."""

    def __init__(self, path):
        self.path = path
        try:
            self._file = h5py.File(path, "r")
        except FileNotFoundError:
            raise ResultError(f"{path}: no such file") from None
        except OSError as error:
            if not h5py.is_hdf5(path):
                raise ResultError(f"{path}: not a result file (HDF5) of microslip; solve, run, sweep, profile and conicity write "
                                  "them") from None
            why = os.strerror(error.errno) if error.errno else DAMAGED
            raise ResultError(f"{path}: {why}") from None
        try:
            found = self.attribute("format", FORMAT)
            if found != FORMAT:
                raise ResultError(f"{path}: has format {found} of result files; this version of microslip reads {FORMAT}")
        except ResultError:
            self._file.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._file.close()

    def __contains__(self, name):
        with self._reading(name):
            return name in self._file

    @contextlib.contextmanager
    def _reading(self, name):
        """Says in words that a part of the file cannot be read, for which HDF5, h5py and numpy raise whatever they like. All
        that touches the file is done within."""
        try:
            yield
        except ResultError:
            raise
        except Exception:
            raise ResultError(f"{self.path}: {name} cannot be read; the file is {DAMAGED}") from None

    def attribute(self, name, default=None):
        """A root attribute as text."""
        with self._reading(f"attribute '{name}'"):
            if name in self._file.attrs:
                return _decoded(self._file.attrs[name])
        if default is None:
            raise ResultError(f"{self.path}: no attribute '{name}'; was it written by microslip?")
        return default

    def group_attribute(self, group, name):
        """An attribute of a group as text."""
        with self._reading(f"attribute '{name}' of {group}"):
            if group not in self._file or name not in self._file[group].attrs:
                raise ResultError(f"{self.path}: no attribute '{name}' of {group}")
            return _decoded(self._file[group].attrs[name])

    def assumption(self, group):
        """Assumption of Hertz or a theory that does not hold in the case, as text; empty: none."""
        with self._reading(group):
            has_one = group in self and "assumes" in self._file[group].attrs
        return self.group_attribute(group, "assumes") if has_one else ""

    def _dataset(self, name):
        with self._reading(name):
            dataset = self._file.get(name)
        if not isinstance(dataset, h5py.Dataset):
            raise ResultError(f"{self.path}: no dataset {name}")
        return dataset

    def text(self, name):
        """A scalar dataset as text."""
        dataset = self._dataset(name)
        with self._reading(name):
            return _decoded(dataset[()])

    def number(self, name):
        """A scalar dataset as a finite number."""
        return float(self.array(name, dimensions=0))

    def array(self, name, dimensions=1, strides=None, finite=True):
        """A dataset as an array of numbers; `strides` takes every stride-th entry along each axis."""
        dataset = self._dataset(name)
        slices = () if strides is None else tuple(slice(stride // 2, None, stride) for stride in strides)
        with self._reading(name):
            if dataset.ndim != dimensions or dataset.size == 0 or dataset.dtype.kind not in "iuf":
                raise ResultError(f"{self.path}: {name} has shape {dataset.shape} and type {dataset.dtype}, "
                                  f"expected {dimensions} dimensions of numbers")
            values = np.asarray(dataset[slices])
        if finite and not np.all(np.isfinite(values)):
            raise ResultError(f"{self.path}: {name} has values that are not finite")
        return values

    def is_number(self, name):
        """Returns whether a dataset has numbers, not texts."""
        dataset = self._dataset(name)
        with self._reading(name):
            return dataset.dtype.kind in "iuf"

    def numbers_of(self, groups):
        """Names of the datasets of numbers in the groups that are there."""
        with self._reading(" or ".join(groups)):
            return [f"{group}/{name}" for group in groups if group in self._file for name, dataset in self._file[group].items()
                    if isinstance(dataset, h5py.Dataset) and dataset.dtype.kind == "f"]

    def scalars_of(self, group):
        """Numbers and texts without dimensions in a group and its groups, by their names from there."""
        found = {}

        def add(name, item):
            if isinstance(item, h5py.Dataset) and item.shape == ():
                value = item[()]
                found[name] = float(value) if item.dtype.kind in "iuf" else _decoded(value)

        with self._reading(group):
            if group in self._file:
                self._file[group].visititems(add)
        return found

    def entry(self, name, index):
        """An entry of a dataset, as a number or as text."""
        dataset = self._dataset(name)
        with self._reading(name):
            value = dataset[index]
        return float(value) if self.is_number(name) else _decoded(value)

    def shape(self, name):
        """Shape of a dataset."""
        dataset = self._dataset(name)
        with self._reading(name):
            return dataset.shape

    def unit(self, name):
        """The unit of a dataset."""
        dataset = self._dataset(name)
        with self._reading(name):
            return _decoded(dataset.attrs.get("unit", "-"))

    def arrays(self, names, **how):
        """Datasets that must have one shape, in the order of the names."""
        values = [self.array(name, **how) for name in names]
        for name, value in zip(names, values):
            if value.shape != values[0].shape:
                raise ResultError(f"{self.path}: {name} has shape {value.shape}, {names[0]} has {values[0].shape}")
        return values
