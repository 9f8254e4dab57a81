#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every public class: repr, copies and pickles of values; what has none of them, and why."""

import copy
import inspect
import pickle
import unittest

import numpy as np

import hodograph
import samples

#: Classes that do not pickle, and why.
LIVING = {
    "LinePool": "threads that work",
    "RecedingHorizon": "a solver with what it remembers of the plan before",
}

def parts(value):
    """What the public properties of a value hold."""
    if type(value).__module__.startswith("hodograph") and not samples.is_enum(type(value)):
        for name in dir(type(value)):
            if name.startswith("_") or callable(getattr(type(value), name)):
                continue
            yield getattr(value, name)
        for name in ("decomposition", "motion", "frame"):
            if callable(getattr(value, name, None)):
                try:
                    yield getattr(value, name)()
                except (TypeError, ValueError):
                    pass
    elif isinstance(value, (list, tuple)):
        yield from value


def gathered():
    """Values by their class, up to three of each."""
    found = {}
    heap = [value for root in samples.ROOTS for value in root()]
    while heap:
        value = heap.pop()
        kind = type(value)
        if isinstance(value, (list, tuple)) and not kind.__module__.startswith("hodograph"):
            heap.extend(value)
        elif kind.__module__.startswith("hodograph"):
            known = found.setdefault(kind, [])
            if len(known) < 3:
                known.append(value)
                heap.extend(parts(value))
    return found


def same(a, b):
    if isinstance(a, np.ndarray):
        return isinstance(b, np.ndarray) and np.array_equal(a, b)
    if isinstance(a, Exception):  # Python compares them by identity
        return isinstance(b, Exception) and a.args == b.args
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    return bool(a == b)


class Values(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = gathered()
        cls.names = {kind: name for name, kind in samples.classes().items()}

    def each(self, check):
        """check(name, value) for all of them, each as a test of its own."""
        for kind, values in self.found.items():
            name = self.names.get(kind)
            if name is None:
                continue
            for value in values:
                with self.subTest(name):
                    check(name, value)

    def test_there_is_a_sample_of_every_class(self):
        wanted = {name for name, kind in samples.classes().items() if not samples.is_enum(kind)}
        found = {self.names[kind] for kind in self.found if kind in self.names}
        self.assertEqual(sorted(wanted - found), [])

    def test_every_public_value_is_of_a_public_class(self):
        hidden = [kind for kind in self.found if kind not in self.names]
        self.assertEqual(hidden, [])

    def test_values_have_a_repr_of_their_own(self):
        def check(name, value):
            text = repr(value)
            self.assertNotIn(" object at 0x", text)
            self.assertTrue(len(text) < 4000, f"{len(text)} characters")
            self.assertIn(name.split(".")[-1], text)

        self.each(check)

    def test_values_pickle(self):
        def check(name, value):
            if name in LIVING:
                with self.assertRaises(TypeError):
                    pickle.dumps(value)
                return
            for protocol in (2, pickle.HIGHEST_PROTOCOL):
                again = pickle.loads(pickle.dumps(value, protocol))
                self.assertIs(type(again), type(value))
                self.assertTrue(same(again, value), "not the same")

        self.each(check)

    def test_values_copy(self):
        def check(name, value):
            for again in () if name in LIVING else (copy.copy(value), copy.deepcopy(value)):
                self.assertIs(type(again), type(value))
                self.assertTrue(same(again, value), "not the same")

        self.each(check)

    def test_values_differ_from_other_things(self):
        def check(_, value):
            self.assertFalse(value == object())
            self.assertTrue(value != object())

        self.each(check)

    def test_properties_cannot_be_written(self):
        def check(name, value):
            for attribute in dir(type(value)):
                held = inspect.getattr_static(type(value), attribute)
                if attribute.startswith("_") or not isinstance(held, property):
                    continue
                with self.assertRaises(AttributeError, msg=f"{name}.{attribute}"):
                    setattr(value, attribute, None)

        self.each(check)

    def test_enumerations_pickle(self):
        for name, kind in samples.classes().items():
            if samples.is_enum(kind):
                for member in kind.__members__.values():
                    self.assertIs(type(pickle.loads(pickle.dumps(member))), kind)
                    self.assertEqual(pickle.loads(pickle.dumps(member)), member)
                    self.assertEqual(copy.deepcopy(member), member)


if __name__ == "__main__":
    unittest.main()
