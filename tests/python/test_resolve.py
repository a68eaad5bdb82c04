# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that meet themselves: what they enclose, by each winding rule, beside libigl and Manifold,
and that what is delivered holds and is an operand again."""

import itertools
import os

import manifold3d
import numpy as np
import pymeshlab
import pytest

import judges
import mesh_laws
import oracles
from conftest import box, crossing_bars, document, joined, sphere
from plain_solids import one_sided
from run_boolean import BLOCKS, run_boolean
from test_reports import load

FAR = box((10, 10, 10), (11, 11, 11))


def turned(mesh):
    return mesh[0], mesh[1][:, ::-1]


def volumes_of(first, second, **parameters):
    """The volumes of the blocks, each of which is closed, holds as stored, and is certified."""
    made = run_boolean(*first, *second, symmetric_difference=True, **parameters)
    result = made["result"]
    for block in (*BLOCKS, "symmetric_difference"):
        assert result[f"{block}_closed"]
        assert result[f"{block}_self_intersections"] == 0
        assert not judges.judge(*made[block]).wrong
    return {block: result[f"{block}_volume"] for block in BLOCKS}


class TestRules:
    """What is inside one layer, by rule."""

    @pytest.mark.parametrize(
        ("layer", "volumes"),
        [
            (joined(box((0, 0, 0), (2, 2, 2)), box((1, 0, 0), (3, 2, 2))), (12, 12, 8)),
            (joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))), (15, 15, 14)),
            (joined(box((0, 0, 0), (4, 4, 2)), box((1, 1, 2), (3, 3, 4))), (40, 40, 40)),
            (joined(box((0, 0, 0), (6, 6, 6)), box((1, 1, 1), (5, 5, 5))), (216, 216, 152)),
            (joined(turned(box((0, 0, 0), (2, 2, 2))), box((4, 0, 0), (5, 1, 1))), (9, 1, 9)),
            (joined(turned(box((0, 0, 0), (2, 2, 2))), box((1, 0, 0), (3, 2, 2))), (8, 4, 8)),
            (joined(box((0, 0, 0), (2, 2, 2)), turned(box((0.5, 0.5, 0.5), (1, 1, 1)))),
             (7.875, 7.875, 7.875)),
            (crossing_bars(), (8.0625, 8.0625, 7.125)),
        ],
        ids=["overlapInFaces", "overlap", "onTop", "nested", "besideInsideOut", "overInsideOut",
             "cavity", "crossing"],
    )
    def test_volumes(self, layer, volumes):
        for rule, volume in zip(("nonzero", "positive", "odd"), volumes):
            made = run_boolean(*layer, *FAR, winding_rule=rule)
            assert made["result"]["first_minus_second_volume"] == pytest.approx(volume, rel=1e-12)
            assert made["result"]["union_volume"] == pytest.approx(volume + 1, rel=1e-12)
            assert not judges.judge(*made["first_minus_second"]).wrong
            swapped = run_boolean(*FAR, *layer, winding_rule=rule)["result"]
            assert swapped["second_minus_first_volume"] == pytest.approx(volume, rel=1e-12)

    def test_aLayerThatIsInsideOutAsAWholeIsTurned(self):
        layer = turned(joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))))
        for rule in ("nonzero", "positive"):
            assert volumes_of(layer, FAR, winding_rule=rule)["union"] == pytest.approx(16)

    def test_aFaceThatIsThereTwiceCountsOnce(self):
        vertices, faces = box((0, 0, 0), (1, 1, 1))
        layer = joined((vertices, np.concatenate([faces, faces[:1]])), box((0.25, 0, 0), (2, 1, 1)))
        assert volumes_of(layer, FAR)["first_minus_second"] == pytest.approx(2)

    def test_verticesMayHangOnEdges(self):
        vertices, faces = box((0, 0, 0), (2, 2, 2))
        edge = {1, 5}  # at y = 0 and z = 2
        hung = next(
            i for i, f in enumerate(faces)
            if edge <= set(f.tolist()) and (vertices[f][:, 2] == 2).all()
        )
        a, b, c = faces[hung]
        while {a, b} != edge:
            a, b, c = b, c, a
        split = np.array([(a, 8, c), (8, b, c)])
        vertices = np.concatenate([vertices, [(1, 0, 2)]])
        layer = vertices, np.concatenate([np.delete(faces, hung, 0), split])
        assert volumes_of(layer, box((1, -1, 1), (3, 1, 3))) == pytest.approx(
            {"union": 15, "intersection": 1, "first_minus_second": 7, "second_minus_first": 7}
        )
        cracked = np.concatenate([vertices[:-1], [(1, 0.125, 2)]])
        with pytest.raises(pymeshlab.PyMeshLabException, match="not closed: 3 edges have"):
            run_boolean(cracked, layer[1], *FAR)


class TestRefusals:
    def test_onlyIfAsked(self):
        mesh_set = document(crossing_bars(), FAR)
        with pytest.raises(pymeshlab.PyMeshLabException, match="self_intersections = resolve"):
            mesh_set.generate_index_boolean(self_intersections="refuse")
        assert mesh_set.mesh(0).selected_face_number() > 0
        assert mesh_set.generate_index_boolean()["union_volume"] == pytest.approx(9.0625)

    def test_whatIsNotSearchedIsNotCertified(self):
        made = run_boolean(*box((0, 0, 0), (2, 2, 2)), *FAR, self_intersections="trust")
        assert made["result"]["union_self_intersections"] == -1
        assert "union_moved_vertices" not in made["result"]

    def test_aLayerIsSearchedThoughTheOtherIsNoEmbeddedSurface(self):
        vertices, faces = box((20, 0, 0), (22, 2, 2))
        misturned = vertices, np.concatenate([faces[:5, ::-1], faces[5:]])
        for layers in ((crossing_bars(), misturned), (misturned, crossing_bars())):
            with pytest.raises(pymeshlab.PyMeshLabException, match="intersects itself"):
                run_boolean(*layers[0], *layers[1], self_intersections="refuse")
            assert volumes_of(*layers)["union"] == pytest.approx(16.0625)

    @pytest.mark.parametrize("mode", ["trust", "refuse"])
    def test_nestedComponentsAreResolvedAllTheSame(self, mode):
        layer = joined(box((0, 0, 0), (2, 2, 2)), box((0.25, 0.375, 0.5), (0.75, 0.875, 1)))
        made = run_boolean(*layer, *FAR, self_intersections=mode)["result"]
        assert made["union_volume"] == pytest.approx(9)

    def test_facesAreTurnedAsTheirNeighboursAre(self):
        vertices, faces = box((0, 0, 0), (2, 2, 2))
        faces = faces.copy()
        faces[:5] = faces[:5, ::-1]
        for rule in ("nonzero", "positive", "odd"):
            volumes = volumes_of((vertices, faces), FAR, winding_rule=rule)
            assert volumes["union"] == pytest.approx(9)

    def test_aOneSidedLayerIsTakenByTheOddRuleOnly(self):
        layer = one_sided()
        for rule in ("nonzero", "positive"):
            with pytest.raises(pymeshlab.PyMeshLabException, match="winding_rule = odd"):
                run_boolean(*layer, *FAR, winding_rule=rule)
        assert volumes_of(layer, FAR, winding_rule="odd")["union"] == pytest.approx(1 + 2 / 3)

    def test_aLayerThatCancelsIsRefused(self):
        cube = box((0, 0, 0), (1, 1, 1))
        with pytest.raises(pymeshlab.PyMeshLabException, match="double-sided"):
            run_boolean(*joined(cube, turned(cube)), *FAR)


# Inputs after reports: volumes of union, intersection and first minus second, by libigl.
REPORTS = {
    "own_output_refused_ny3_dx10_plain": (924, 186, 186),
    "prusa228_two_overlapping_bodies_one_layer_both_cut": (35.5, 3.5, 15.5),
    "pymesh278_two_cubes_one_layer": (70, 7.5, 7.5),
    "touching_part_of_face_one_layer": (23.5, 2.5, 7.5),
    "vtkbool_intersecting_strips": (125, 29.909586912, 95.090413088),
    "manifold144_box_with_through_cavity_flush": (28902319550, 301734400, 444993950),
    "cgal_tet_si_and_box": (0.198893914, 0.00249889884, 0.171893914),
}


class TestReports:
    @pytest.mark.parametrize("scalar", ["host", "float"])
    @pytest.mark.parametrize("name", REPORTS)
    def test_theVolumesAreLibiglsAndResultsHoldAndAreOperandsAgain(self, name, scalar):
        first, second = load(name)
        volumes = volumes_of(first, second, certify_as=scalar)
        found = [volumes[block] for block in BLOCKS[:3]]
        assert found == pytest.approx(REPORTS[name], rel=1e-8 if scalar == "host" else 1e-5)
        union = run_boolean(*first, *second, certify_as=scalar)["union"]
        again = run_boolean(*union, *second, certify_as=scalar)["result"]
        assert not again["self_intersecting_faces_first"]
        assert again["union_volume"] == pytest.approx(volumes["union"], rel=1e-5)

    def test_twoCrossingFaultsInOneLayerCutABlockIntoFour(self):
        mesh_set = document(*load("gempy495_block_and_two_crossing_faults_in_one_layer"))
        result = mesh_set.generate_index_boolean_split(first_mesh=0, second_mesh=1)
        assert result["sub_blocks"] == 4
        assert sum(result["sub_blocks_volumes"]) == pytest.approx(8)
        assert result["sub_blocks_in_first"].tolist() == [1] * 4

    def test_facesDoubledInOppositeDirectionsLeaveALayerClosed(self):
        mesh_set = document(*load("trimesh_joined_tetrahedra_and_plane"))
        result = mesh_set.generate_index_boolean_split(first_mesh=0, second_mesh=1)
        assert sum(result["sub_blocks_in_first"]) == result["sub_blocks"] > 0


def assembly(rng, count):
    """Boxes and spheres that overlap, in one layer."""
    parts = []
    for _ in range(count):
        low = rng.uniform(-1, 1, 3)
        if rng.random() < 0.5:
            parts.append(box(low, low + rng.uniform(0.2, 1, 3)))
        else:
            parts.append(sphere(low, rng.uniform(0.2, 0.6), 1))
    return parts


class TestAssemblies:
    """Random assemblies as one layer, against unions of their parts."""

    @pytest.mark.parametrize("seed", range(int(os.environ.get("INDEXBOOLEAN_ASSEMBLIES", 12))))
    def test_volumesAreLibiglsAndManifolds(self, seed):
        rng = np.random.default_rng(seed)
        parts = assembly(rng, (3, 4, 6, 9, 14, 30, 64)[seed % 7]), assembly(rng, 3)
        layers = [joined(*some) for some in parts]
        volumes = volumes_of(*layers)
        solids = [
            manifold3d.Manifold.batch_boolean(
                [oracles._to_manifold(*part) for part in some], manifold3d.OpType.Add
            )
            for some in parts
        ]
        assert volumes["union"] == pytest.approx((solids[0] + solids[1]).volume(), rel=1e-9)
        for block in BLOCKS:
            libigl = mesh_laws.volume(*oracles.libigl_block(block, *layers[0], *layers[1]))
            assert volumes[block] == pytest.approx(libigl, rel=1e-9, abs=1e-12)

    @pytest.mark.parametrize("seed", range(4))
    def test_whatIsDeliveredIsAnOperandOfTheNextRun(self, seed):
        rng = np.random.default_rng(100 + seed)
        first, second, third = (joined(*assembly(rng, 4)) for _ in range(3))
        union = run_boolean(*first, *second)["union"]
        chained = run_boolean(*union, *third)
        at_once = run_boolean(*joined(first, second), *third)
        for block in BLOCKS:
            assert chained["result"][f"{block}_volume"] == pytest.approx(
                at_once["result"][f"{block}_volume"], rel=1e-9
            )
            parts = [
                mesh_laws.component_count(made[block][1], len(made[block][0]))
                for made in (chained, at_once)
            ]
            assert parts[0] == parts[1]
        assert not chained["result"]["self_intersecting_faces_first"]

    def test_anyOrderOfPartsGivesTheSameVolume(self):
        rng = np.random.default_rng(7)
        parts = assembly(rng, 4)
        found = {
            volumes_of(joined(*order), FAR)["union"] for order in itertools.permutations(parts)
        }
        assert max(found) - min(found) < 1e-12
