# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangulations that are edited are, at each moment, those of the points that are there."""

import copy
import pickle
import threading
import unittest

import numpy as np
from vtkflipflop.arrays import (
    ConstrainedTriangulation,
    EditableTriangulation,
    InputError,
    RegularTriangulation,
    regular_triangulation,
)


def from_nothing(edited):
    """The same of a run on the points that are there."""
    points, weights = edited.points, edited.weights
    if not len(edited.constraints):
        return regular_triangulation(points, weights, non_finite="ignore")
    return regular_triangulation(points, constraints=edited.constraints, non_finite="ignore")


class TestEdit(unittest.TestCase):
    def check(self, edited):
        wanted = from_nothing(edited)
        found = edited.snapshot()
        for name in ("simplices", "vertices", "hidden", "neighbors", "edges"):
            np.testing.assert_array_equal(getattr(found, name), getattr(wanted, name), name)
            np.testing.assert_array_equal(getattr(edited, name), getattr(wanted, name), name)
        self.assertEqual(found.dimension, wanted.dimension)
        if isinstance(wanted, ConstrainedTriangulation):
            np.testing.assert_array_equal(found.fixed_edges, wanted.fixed_edges)
            np.testing.assert_array_equal(found.constraint_of, wanted.constraint_of)
        self.assertTrue(found.validate())

    def test_edits(self):
        for weighted in (False, True):
            random = np.random.default_rng(5)
            edited = EditableTriangulation()
            self.check(edited)
            for step in range(40):
                with self.subTest(weighted=weighted, step=step):
                    count = int(random.integers(1, 40))
                    points = random.integers(0, 12, (count, 2)).astype(float)
                    ids = edited.insert(points, random.random(count) if weighted else None)
                    np.testing.assert_array_equal(ids, np.arange(ids[0], ids[0] + count))
                    self.check(edited)
                    there = edited.ids
                    gone = random.permutation(there)[: len(there) // 3]
                    edited.remove(gone)
                    self.assertEqual(len(edited), len(there) - len(gone))
                    self.assertFalse(set(gone) & set(edited.ids))
                    some = random.permutation(edited.ids)[:5]
                    edited.move(some, random.random((len(some), 2)) * 12)
                    self.check(edited)

    def test_one_point(self):
        edited = EditableTriangulation([[0, 0], [4, 0], [0, 4]])
        id = edited.insert([1, 1])
        self.assertEqual((int(id), np.ndim(id)), (3, 0))
        self.assertIn(id, edited)
        edited.move(id, [2, 1])
        np.testing.assert_array_equal(edited.points[3], [2, 1])
        edited.remove(id)
        self.assertNotIn(3, edited)
        self.assertTrue(np.isnan(edited.points[3]).all())
        self.assertEqual(int(edited.insert([1, 1])), 4)

    def test_hidden_points_come_back(self):
        edited = EditableTriangulation([[0, 0], [4, 0], [0, 4], [1, 1]], [0, 0, 0, 5.0])
        id = edited.insert([1.25, 1], 0.5)
        np.testing.assert_array_equal(edited.hidden, [id])
        edited.remove(3)
        np.testing.assert_array_equal(edited.hidden, [])
        self.check(edited)

    def test_constraints(self):
        edited = EditableTriangulation([[0, 0], [4, 0], [4, 4], [0, 4]])
        numbers = edited.add_constraints([[0, 2]])
        np.testing.assert_array_equal(numbers, [0])
        self.check(edited)
        middle = edited.insert([2, 2])
        self.assertEqual(edited.divided_edges, 1)
        np.testing.assert_array_equal(edited.snapshot().fixed_edges, [[0, 4], [2, 4]])
        with self.assertRaisesRegex(InputError, "no constraint ends there: at index 0"):
            edited.remove([0])
        edited.move(middle, [3, 1])
        with self.assertRaises(InputError) as raised:
            edited.add_constraints([[1, 3]])
        self.assertEqual((raised.exception.code, raised.exception.index, raised.exception.count),
                         ("constraints_cross", 0, 0))
        self.check(edited)
        edited.move(middle, [2, 2])
        edited.add_constraints([[3, 4, 1]])
        np.testing.assert_array_equal(edited.constraint_numbers, [0, 1, 2])
        self.check(edited)
        edited.remove_constraints(0)
        np.testing.assert_array_equal(edited.constraints, [[3, 4], [4, 1]])
        self.check(edited)
        edited.remove_constraints([1, 2])
        self.assertNotIsInstance(edited.snapshot(), ConstrainedTriangulation)
        self.check(edited)

    def test_queries(self):
        random = np.random.default_rng(6)
        edited = EditableTriangulation(random.random((200, 2)))
        edited.remove(np.arange(0, 200, 3))
        wanted = from_nothing(edited)
        positions = random.random((50, 2))
        values = random.random(200)
        np.testing.assert_array_equal(edited.locate(positions), wanted.locate(positions))
        np.testing.assert_array_equal(edited.nearest(positions), wanted.nearest(positions))
        for method in ("linear", "natural", "clough-tocher", "laplace"):
            np.testing.assert_array_equal(
                edited.interpolate(values, positions, method), wanted.interpolate(values, positions, method)
            )
        np.testing.assert_array_equal(
            edited.to_image(values, shape=(9, 7)).array, wanted.to_image(values, shape=(9, 7)).array
        )

    def test_snapshots_stay(self):
        edited = EditableTriangulation(np.random.default_rng(7).random((30, 2)))
        first = edited.snapshot()
        simplices = first.simplices.copy()
        self.assertIs(edited.snapshot(), first)
        self.assertIsInstance(first, RegularTriangulation)
        edited.remove(3)
        self.assertIsNot(edited.snapshot(), first)
        np.testing.assert_array_equal(first.simplices, simplices)
        self.assertTrue(first.validate())

    def test_copies(self):
        edited = EditableTriangulation([[0, 0], [4, 0], [4, 4], [0, 4], [9, 9]], constraints=[[0, 2], [0, 1]])
        edited.remove(4)
        edited.remove_constraints(0)
        for other in (edited.copy(), copy.copy(edited), copy.deepcopy(edited), pickle.loads(pickle.dumps(edited))):
            np.testing.assert_array_equal(other.simplices, edited.simplices)
            np.testing.assert_array_equal(other.constraint_numbers, [1])
            self.assertEqual(int(other.insert([2, 2])), 5)
            np.testing.assert_array_equal(other.add_constraints([[0, 3]]), [2])
            self.check(other)
        self.assertEqual(len(edited), 4)
        edited.remove_constraints(1)
        edited.remove(edited.ids)
        empty = pickle.loads(pickle.dumps(edited))
        np.testing.assert_array_equal(empty.insert([[0, 0], [1, 0]]), [5, 6])
        np.testing.assert_array_equal(empty.add_constraints([[5, 6]]), [2])
        weighted = EditableTriangulation([[0, 0], [4, 0], [0, 4], [1, 1]], [0, 0, 0, 5.0])
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(weighted)).weights, weighted.weights)

    def test_bad_input_changes_nothing(self):
        edited = EditableTriangulation(np.random.default_rng(8).random((20, 2)), constraints=[[0, 1]])
        before = edited.snapshot()
        edited.remove(7)
        edited.insert(before.points[7])
        wanted = edited.simplices.copy()
        for wrong, sentence in (
            (lambda: edited.insert([[0, np.nan]]), "NaN or infinite: first at point 0, 1 such"),
            (lambda: edited.insert([0, np.inf]), "NaN or infinite"),
            (lambda: edited.remove(7), "of a point that is in the triangulation: at index 0"),
            (lambda: edited.remove([3, 99]), "of a point that is in the triangulation: at index 1"),
            (lambda: edited.remove([3, -1]), "of a point that is in the triangulation: at index 1"),
            (lambda: edited.remove([3, 4, 3]), "must not be there twice: at index 2"),
            (lambda: edited.remove([3, 1]), "no constraint ends there: at index 1"),
            (lambda: edited.move([3, 7], [[0, 0], [1, 1]]), "of a point that is in the triangulation: at index 1"),
            (lambda: edited.move(3, [0, np.nan]), "NaN or infinite"),
            (lambda: edited.insert([1, 1], 2.0), "constraints or weights other than 0, not both"),
            (lambda: edited.add_constraints([[3, 7]]), "not in the triangulation: constraint 0, point 7"),
            (lambda: edited.remove_constraints([0, 5]), "of a constraint that is in the triangulation: at index 1"),
        ):
            with self.subTest(sentence=sentence), self.assertRaisesRegex(InputError, sentence):
                wrong()
            np.testing.assert_array_equal(edited.simplices, wanted)
            self.check(edited)
        with self.assertRaisesRegex(ValueError, "2 ids, 1 points"):
            edited.move([2, 3], [[0, 0]])
        with self.assertRaisesRegex(TypeError, "ids are an array"):
            edited.remove(0.5)
        self.assertEqual(int(edited.insert([3, 3])), 21)

    def test_points_left_out(self):
        edited = EditableTriangulation([[0, 0], [np.nan, 1], [1, 0], [0, 1]], non_finite="ignore")
        np.testing.assert_array_equal(edited.ids, [0, 2, 3])
        self.check(edited)

    def test_from_a_result(self):
        random = np.random.default_rng(11)
        points = random.integers(0, 30, (60, 2)).astype(float)
        points[7, 0] = np.nan
        grid = [[x, y] for x in range(5) for y in range(5)]
        for result in (
            regular_triangulation(points, random.random(60), non_finite="ignore"),
            regular_triangulation(grid, constraints=[[0, 24], [3, 9]], polygons=[[0, 4, 24, 20]]),
        ):
            edited = EditableTriangulation(result)
            np.testing.assert_array_equal(edited.vertices, result.vertices)
            np.testing.assert_array_equal(edited.hidden, result.hidden)
            self.check(edited)
            edited.insert(random.random((5, 2)) * 4)
            self.check(edited)
            with self.assertRaisesRegex(ValueError, "leave them out"):
                EditableTriangulation(result, constraints=[[0, 1]])
        self.assertEqual(len(edited.constraints), 6)

    def test_threads_wait(self):
        edited = EditableTriangulation(np.random.default_rng(9).random((100, 2)))

        def work(seed):
            random = np.random.default_rng(seed)
            for _ in range(50):
                ids = edited.insert(random.random((3, 2)))
                edited.locate(random.random((2, 2)))
                edited.remove(ids[:2])

        threads = [threading.Thread(target=work, args=(seed,)) for seed in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(edited), 300)
        self.check(edited)

    def test_progress_must_not_edit(self):
        edited = EditableTriangulation()
        seen = []

        def use(fraction):
            for read in (
                edited.snapshot,
                edited.__len__,
                edited.__repr__,
                lambda: 0 in edited,
                lambda: edited.divided_edges,
            ):
                with self.assertRaisesRegex(RuntimeError, "being edited"):
                    read()
            seen.append(fraction)

        edited.insert(np.random.default_rng(10).random((50000, 2)), progress=use)
        self.assertTrue(seen)
        self.check(edited)


if __name__ == "__main__":
    unittest.main()
