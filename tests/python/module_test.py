# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause

"""The Python module against the programs, and what it refuses.

Run by ctest with PYTHONPATH on the build's package, FATHOM_TOOLS_DIR and FATHOM_DATA_DIR.
"""

import ast
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np

import fathom

TOOLS = pathlib.Path(os.environ["FATHOM_TOOLS_DIR"])
FLATFISH = os.path.join(os.environ["FATHOM_DATA_DIR"], "flatfish")
VEHICLES = pathlib.Path(os.environ["FATHOM_DATA_DIR"]) / "vehicles"


def run_tool(name, *arguments):
    return subprocess.run(
        [str(TOOLS / f"fathom_{name}"), *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )


def coasting():
    """Speed that falls by exp(-0.1 t), under no force, with small noise."""
    t = np.arange(0.0, 40.0, 0.1)
    noise = 1e-3 * np.random.default_rng(1).standard_normal(t.size)
    return t, np.exp(-0.1 * t) + noise


class Scratch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def json_of_tool(self, name, flag, *arguments):
        """What a tool writes, as a dict."""
        file = self.folder / "tool.json"
        run = run_tool(name, *arguments, f"--{flag}={file}")
        self.assertTrue(file.exists(), run.stdout + run.stderr)
        return json.loads(file.read_text())


class EqualsTheTools(Scratch):
    def test_identify_gives_the_model_file_to_the_last_digit(self):
        for family in ["least_squares", "adaptive", "output_error"]:
            with self.subTest(family=family):
                theirs = self.json_of_tool(
                    "identify", "model", f"--log={FLATFISH}", "--dof=surge", f"--family={family}"
                )
                ours = fathom.identify(FLATFISH, dof="surge", family=family)
                self.assertEqual(ours.to_dict(), theirs)

    def test_identify_takes_the_options_of_the_tool(self):
        theirs = self.json_of_tool(
            "identify",
            "model",
            f"--log={FLATFISH}",
            "--dof=heave",
            "--held_out=100:120,240:300",
            "--huber=0",
            "--shooting_window=50",
        )
        log = fathom.open_log(FLATFISH, held_out=[(100, 120), (240, 300)])
        ours = fathom.identify(log, dof="heave", huber=0.0, shooting_window=50.0)
        self.assertEqual(ours.to_dict(), theirs)

    def test_identify_takes_gains(self):
        gains = [-0.1, 1.1e-5, 20.0, 0.7, 0.015]
        theirs = self.json_of_tool(
            "identify",
            "model",
            f"--log={FLATFISH}",
            "--dof=surge",
            "--family=adaptive",
            "--integrator=euler",
            "--gains=" + ",".join(map(str, gains)),
        )
        ours = fathom.identify(
            FLATFISH, dof="surge", family="adaptive", integrator="euler", gains=gains
        )
        self.assertEqual(ours.to_dict(), theirs)

    def test_compare_gives_the_comparison_file(self):
        theirs = self.json_of_tool("compare", "json", f"--log={FLATFISH}", "--dofs=surge")
        self.assertEqual(fathom.compare(FLATFISH, dofs=["surge"]).to_dict(), theirs)

    def test_check_gives_the_check_file(self):
        theirs = self.json_of_tool("check", "json", f"--log={FLATFISH}")
        self.assertEqual(fathom.check(FLATFISH).to_dict(), theirs)

    def test_simulate_gives_the_score_and_the_prediction(self):
        model = fathom.identify(FLATFISH, dof="surge").model
        file, out = self.folder / "model.json", self.folder / "out.csv"
        model.save(file)
        theirs = self.json_of_tool(
            "simulate", "json", f"--model={file}", f"--log={FLATFISH}", f"--out={out}"
        )
        ours = fathom.simulate(model, FLATFISH)
        self.assertEqual(ours.to_dict(), theirs)
        rows = np.loadtxt(out, delimiter=",", skiprows=1)
        np.testing.assert_array_equal(ours.time, rows[:, 0])
        np.testing.assert_array_equal(ours.velocity, rows[:, 1])

    def test_diagnose_gives_the_verdict_file(self):
        log = self.folder / "lag"
        run = run_tool(
            "synthesize",
            f"--vehicle={VEHICLES / 'flatfish.yaml'}",
            f"--experiment={VEHICLES.parent / 'experiments' / 'surge_multisine.yaml'}",
            "--seed=1",
            "--effects=thrust_dead_zone:width=8",
            f"--out={log}",
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        theirs = self.json_of_tool("diagnose", "verdict", f"--log={log}", "--dof=surge")
        ours = fathom.diagnose(log, dof="surge")
        self.assertEqual(ours.to_dict(), theirs)
        self.assertEqual([cause.effect for cause in ours.causes], ["thrust_dead_zone"])
        width = ours.causes[0].parameters["thrust_dead_zone.width"]
        low, high = width.interval
        self.assertTrue(low < 8.0 < high)
        self.assertEqual(width.unit, "N")
        # The model with its cause runs, as the verdict file does.
        file = self.folder / "tool.json"
        by_file = fathom.simulate(file, log)
        by_model = fathom.simulate(ours.model, log)
        np.testing.assert_array_equal(by_file.velocity, by_model.velocity)
        self.assertIn("<iframe", ours._repr_html_())

    def test_free_decay_gives_the_decay_file(self):
        t, v = coasting()
        file = self.folder / "decay.csv"
        np.savetxt(file, np.column_stack([t, v]), delimiter=",", header="t,v", comments="")
        theirs = self.json_of_tool("identify", "json", f"--log={file}", "--dof=surge")
        ours = fathom.free_decay(str(file), dof="surge")
        self.assertEqual(ours.to_dict(), theirs)
        low, high = ours.parameters["linear_damping / inertia"].interval
        self.assertTrue(low <= 0.1 <= high)

    def test_coupled_models_are_those_of_the_tools(self):
        dofs = ["surge", "yaw"]
        theirs = self.json_of_tool(
            "identify",
            "model",
            f"--log={FLATFISH}",
            "--dofs=surge,yaw",
            "--structure=diagonal",
            "--free=linear_damping.surge.yaw",
        )
        ours = fathom.identify(
            FLATFISH, dofs=dofs, structure="diagonal", free=["linear_damping.surge.yaw"]
        )
        self.assertEqual(ours.to_dict(), theirs)
        model = ours.model
        self.assertEqual(model.dofs, dofs)
        self.assertEqual(model.inertia.shape, (6, 6))
        self.assertEqual(model.inertia[0, 0], model.parameters["inertia.surge"].value)
        file = self.folder / "coupled.json"
        model.save(file)
        theirs = self.json_of_tool(
            "simulate", "json", f"--model={file}", f"--log={FLATFISH}", "--horizon=5"
        )
        prediction = fathom.simulate(model, FLATFISH, horizon=5.0)
        self.assertEqual(prediction.to_dict(), theirs)
        self.assertEqual(prediction.velocity["yaw"].shape, prediction.time.shape)
        self.assertIsInstance(fathom.read_model(file), fathom.CoupledModel)


def synthesize(log, experiment, film, vehicle="flatfish", *more):
    """A log of a camera that films markers; the experiment is the text of its file."""
    file = log.with_suffix(".yaml")
    file.write_text(experiment)
    run = run_tool(
        "synthesize",
        f"--vehicle={VEHICLES / vehicle}.yaml",
        f"--experiment={file}",
        f"--film={film}",
        f"--out={log}",
        *more,
    )
    assert run.returncode == 0, run.stderr
    return log


class Filmed(unittest.TestCase):
    """A minute seen as corners, and a second as images."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        films = VEHICLES.parent / "films"
        cls.minute = synthesize(
            cls.folder / "minute",
            "name: minute\nduration: 60\ncommand_rate: 10\nsurge: {control: open_loop, "
            "initial_speed: 0, input: {kind: square, amplitude: 40, frequency: 0.5, offset: -0.81}}\n"
            "velocity: {rate: 10, noise: {surge: 0.01}}\nheld_out: [48, 60]\n",
            films / "wall.yaml",
        )
        film = cls.folder / "film.yaml"
        film.write_text(
            f"camera: {films}/wall_camera.yaml\ntags: {films}/wall_four_tags.yaml\n"
            f"mount: {films}/wall_mount.yaml\nwater: {{attenuation: 0.1, noise: 2}}\n"
        )
        cls.images = synthesize(
            cls.folder / "images",
            "name: images\nduration: 1.2\ncommand_rate: 10\nsurge: {control: open_loop, "
            "initial_speed: 0.3, input: {kind: sine, amplitude: 50, frequency: 1}}\npose: {rate: 10}\n",
            film,
            "flatfish",
            "--render",
        )

    def tool(self, name, *arguments):
        run = run_tool(name, *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)

    def json_in(self, name):
        return json.loads((self.folder / name).read_text())

    def refuses(self, pattern, call, *arguments, **options):
        with self.assertRaisesRegex(ValueError, pattern):
            call(*arguments, **options)


class Tracked(Filmed):
    """fathom.track, against fathom_track."""

    def test_track_gives_the_summary_and_the_log_of_the_tool(self):
        for log, more, options in [
            (self.images, [], {}),
            (self.images, ["--quad_decimate=2", "--threads=2"], dict(quad_decimate=2.0, threads=2)),
            (self.images, ["--from=images", "--gate=3"], dict(from_="images", gate=3.0)),
            (self.images, ["--estimate_markers"], dict(estimate_markers=True)),
            (self.minute, [], {}),
        ]:
            with self.subTest(log=log.name, more=more), tempfile.TemporaryDirectory() as folder:
                theirs, ours = pathlib.Path(folder) / "theirs", pathlib.Path(folder) / "ours"
                self.tool(
                    "track",
                    f"--log={log}",
                    f"--out={theirs}",
                    f"--summary={self.folder / 'track.json'}",
                    *more,
                )
                track = fathom.track(log, **options)
                self.assertEqual(track.to_dict(), self.json_in("track.json"))
                track.save(ours)
                for file in ["pose.csv", "detections.csv", "log.yaml", "tags.yaml"]:
                    self.assertEqual((ours / file).read_text(), (theirs / file).read_text(), file)
                self.refuses("is there already", track.save, ours)

    def test_a_trajectory_is_arrays(self):
        track = fathom.track(fathom.open_log(self.minute))
        path = track.trajectory
        n = len(path)
        self.assertGreater(n, 500)
        self.assertEqual(path.time.shape, (n,))
        self.assertEqual(path.position.shape, (n, 3))
        self.assertEqual(path.quaternion.shape, (n, 4))
        self.assertEqual(path.covariance.shape, (n, 6, 6))
        np.testing.assert_allclose(np.linalg.norm(path.quaternion, axis=1), 1.0)
        np.testing.assert_array_equal(path.position[:, 2], path.pose["z"])
        np.testing.assert_array_equal(np.sqrt(path.covariance[:, 1, 1]), path.pose["sy"])
        np.testing.assert_allclose(path.covariance, path.covariance.transpose(0, 2, 1), atol=1e-12)
        self.assertEqual(path.to_dict()["x"], path.position[:, 0].tolist())
        self.assertEqual(track.camera.position.shape, (n, 3))
        self.assertEqual(track.detections["u0"].shape, track.detections["t"].shape)
        self.assertGreater(track.corner_sigma, 0.1)
        # The poses serve as a log from arrays.
        log = fathom.open_log(self.minute)
        again = fathom.Log.from_arrays(log.command, None, path.pose, dof="surge")
        np.testing.assert_array_equal(again.pose["x"], path.position[:, 0])

    def test_velocities_are_put_right_when_a_log_is_opened(self):
        plain = fathom.open_log(self.minute).velocity
        turned = fathom.open_log(self.minute, correct={"u": -2.0}).velocity
        np.testing.assert_array_equal(turned["u"], -2.0 * plain["u"])
        late = fathom.open_log(self.minute, late={"u": 0.5}).velocity
        np.testing.assert_allclose(
            late["u"], np.interp(late["t"] + 0.5, plain["t"], plain["u"]), atol=1e-12
        )
        with self.assertRaisesRegex(ValueError, "correct: 'u' by 0, expected a finite factor"):
            fathom.open_log(self.minute, correct={"u": 0.0})

    def test_what_cannot_be_tracked_is_a_value_error(self):
        track = fathom.track
        self.refuses("is no folder, expected a log folder", track, self.folder / "nowhere")
        self.refuses("from_: is 'video', expected images", track, self.minute, from_="video")
        self.refuses("expected from_=.images. too", track, self.minute, threads=2)
        self.refuses("gate: is nan", track, self.minute, gate=float("nan"))
        self.refuses("threads: is 0, expected 1 to 256", track, self.images, threads=0)
        self.refuses("quad_decimate is nan", track, self.images, quad_decimate=float("nan"))
        self.refuses("max_hamming is -1", track, self.images, max_hamming=-1)
        self.refuses("without estimate_markers", track, self.minute, reference=4)
        self.refuses("expected one of 4", track, self.minute, reference=9, estimate_markers=True)
        lost = track(self.minute, gate=1e-300)
        self.assertFalse(lost.is_usable)
        self.refuses("no usable trajectory", lambda: lost.trajectory)
        self.refuses("no usable trajectory", lost.save, self.folder / "lost")
        self.assertIn("no usable trajectory", repr(lost))

    def test_results_show_themselves(self):
        track = fathom.track(self.minute)
        for result in [track, track.trajectory]:
            self.assertGreater(len(repr(result).splitlines()), 2)
            self.assertTrue(result._repr_html_().lstrip().startswith("<"))


class Refined(Filmed):
    """fathom.refine on corners, against fathom_refine."""

    def test_refine_gives_the_files_of_the_tool(self):
        path = self.folder / "path.csv"
        for more, options in [
            ([], {}),
            (["--initial_guess=least_squares"], dict(initial_guess="least_squares")),
            (["--size_scale_std=0.03"], dict(size_scale_std=0.03)),
        ]:
            with self.subTest(more=more):
                self.tool(
                    "refine",
                    f"--log={self.minute}",
                    "--dof=surge",
                    f"--json={self.folder / 'rows.json'}",
                    f"--model={self.folder / 'model.json'}",
                    f"--trajectory={path}",
                    *more,
                )
                ours = fathom.refine(self.minute, dof="surge", **options)
                self.assertTrue(ours.is_usable, ours.message)
                self.assertEqual(ours.to_dict(), self.json_in("rows.json"))
                self.assertEqual(ours.model.to_dict(), self.json_in("model.json"))
                ours.trajectory.save(self.folder / "ours.csv")
                self.assertEqual((self.folder / "ours.csv").read_text(), path.read_text())
        self.assertIn("<iframe", ours._repr_html_())
        self.assertIn("Joint", repr(ours))
        low, high = ours.parameters["inertia"].interval
        self.assertTrue(low < ours.parameters["inertia"].value < high)

    def test_a_log_whose_poses_are_of_its_detections_is_refined_alike(self):
        bare = self.folder / "bare"
        shutil.copytree(self.minute, bare)
        (bare / "velocity.csv").unlink()
        opened = fathom.open_log(bare)
        self.assertIsNotNone(opened.pose)
        by_path = fathom.refine(bare)
        self.assertEqual(fathom.refine(opened).to_dict(), by_path.to_dict())
        self.assertFalse(any("pose.csv is not read" in remark for remark in by_path.remarks))

    def test_what_cannot_be_refined_is_a_value_error(self):
        refine, minute = fathom.refine, self.minute
        self.refuses("clock_offset_std is nan", refine, minute, clock_offset_std=float("nan"))
        self.refuses("mount_angle_std is -1", refine, minute, mount_angle_std=-1.0)
        self.refuses("initial_guess: is 'joint'", refine, minute, initial_guess="joint")
        self.refuses("structure: goes with dofs", refine, minute, structure="full")
        self.refuses("true_poses: goes with dofs", refine, minute, true_poses="pose.csv")
        self.refuses("dof: goes with a model of one", refine, minute, dofs=["yaw"], dof="yaw")
        self.refuses("window is -1", refine, minute, dofs=["surge"], window=-1.0)
        self.refuses("holds no detections.csv", refine, self.images)
        self.refuses("hold the same data", refine, [minute, minute])
        t, v = coasting()
        arrays = fathom.Log.from_arrays(None, {"t": t, "u": v}, dof="surge")
        self.refuses("is of arrays, expected a log folder", refine, arrays)
        self.refuses("is of arrays, expected a log folder", fathom.track, arrays)
        # Beyond reason, but numbers.
        refine(minute, clock_offset_std=1e300)


class FilmedTogether(Scratch):
    def test_refine_takes_several_degrees_of_freedom(self):
        data = VEHICLES.parent
        text = (data / "experiments" / "film_planar.yaml").read_text()
        text = text.replace("duration: 120", "duration: 40").replace("[100, 120]", "[30, 40]")
        log = synthesize(
            self.folder / "plane",
            text.replace("logged: false", "logged: true"),
            data / "films" / "wall_four_still.yaml",
            "planar_rov",
        )
        path = self.folder / "plane.csv"
        theirs = self.json_of_tool(
            "refine",
            "model",
            f"--log={log}",
            "--dofs=surge,sway,yaw",
            "--structure=symmetric",
            f"--trajectory={path}",
        )
        ours = fathom.refine(
            log,
            dofs=["surge", "sway", "yaw"],
            structure="symmetric",
            true_poses=log / "pose.csv",
        )
        self.assertEqual(ours.to_dict(), theirs)
        ours.trajectory.save(self.folder / "ours.csv")
        self.assertEqual((self.folder / "ours.csv").read_text(), path.read_text())
        self.assertEqual(ours.model.inertia.shape, (6, 6))
        self.assertLess(ours.path_errors["refined"][0], ours.path_errors["pnp"][0])
        self.assertIn("Path error", repr(ours))


class Arrays(Scratch):
    def arrays(self):
        log = fathom.open_log(FLATFISH)
        return log, {"command": log.command, "velocity": log.velocity}

    def test_a_log_from_arrays_is_the_log_of_the_files(self):
        log, streams = self.arrays()
        again = fathom.Log.from_arrays(**streams, dof=log.dofs, held_out=log.held_out)
        self.assertEqual(again.fingerprint, log.fingerprint)
        ours = fathom.identify(again, dof="surge").to_dict()
        theirs = fathom.identify(log, dof="surge").to_dict()
        for key in ["parameters", "covariance", "fit", "held_out"]:
            self.assertEqual(ours[key], theirs[key])

    def test_shapes_and_types(self):
        log, streams = self.arrays()
        rows = streams["velocity"]["t"].size
        self.assertEqual(streams["velocity"]["u"].shape, (rows,))
        self.assertEqual(streams["velocity"]["u"].dtype, np.float64)
        model = fathom.identify(log, dof="surge").model
        self.assertEqual(model.covariance.shape, (4, 4))
        self.assertEqual(list(model.parameters)[0], "inertia")
        number = model.parameters["inertia"]
        self.assertEqual(number.unit, "kg")
        self.assertAlmostEqual(number.std**2, model.covariance[0, 0], delta=1e-9 * number.std**2)
        low, high = number.interval
        self.assertAlmostEqual(high - low, 2 * 1.96 * number.std, delta=1e-9 * number.value)
        prediction = fathom.simulate(model, log)
        for array in [prediction.time, prediction.velocity, prediction.measured]:
            self.assertEqual(array.shape, (rows,))
        self.assertEqual(prediction.is_held_out.dtype, np.bool_)
        held = prediction.is_held_out
        mae = np.mean(np.abs(prediction.velocity - prediction.measured)[held])
        self.assertAlmostEqual(prediction.held_out.mae, mae, delta=1e-12)

    def test_lists_integers_and_strides_serve_as_arrays(self):
        t = np.arange(0, 400)
        u = np.stack([np.sin(0.1 * t), np.zeros(t.size)], axis=1)[:, 0]
        force = [float(100 * np.cos(0.1 * s)) for s in t]
        log = fathom.Log.from_arrays({"t": t, "tau_surge": force}, {"t": t, "u": u}, dof="surge")
        np.testing.assert_array_equal(log.velocity["u"], u)
        self.assertEqual(log.velocity["t"].dtype, np.float64)

    def test_what_python_does_with_an_array_changes_no_log(self):
        log = fathom.open_log(FLATFISH)
        log.velocity["u"][:] = 0.0
        self.assertGreater(np.abs(log.velocity["u"]).max(), 0.0)

    def test_a_vehicle_file_turns_thruster_speeds_into_forces(self):
        t = np.arange(0.0, 60.0, 0.1)
        speeds = {f"thruster_{i}": 5.0 * np.sin(0.3 * t) for i in range(1, 5)}
        log = fathom.Log.from_arrays(
            {"t": t, **speeds},
            {"t": t, "u": np.sin(0.3 * t)},
            dof="surge",
            vehicle=VEHICLES / "survey_rov.yaml",
        )
        self.assertIn("tau_surge", log.command)
        self.assertGreater(log.mass, 0.0)


class Refusals(Scratch):
    def refuses(self, pattern, call, *arguments, **options):
        with self.assertRaisesRegex(ValueError, pattern) as caught:
            call(*arguments, **options)
        # Options have no dashes here, but for those of commands to be typed.
        self.assertNotIn("--", re.sub(r"fathom_\w+( --\S+)+", "", str(caught.exception)))

    def test_a_bad_path_is_a_value_error_with_the_words_of_the_tool(self):
        run = run_tool("identify", "--log=no/such/log", "--dof=surge")
        with self.assertRaises(ValueError) as caught:
            fathom.open_log("no/such/log")
        self.assertIn(str(caught.exception), " ".join(run.stderr.split()))
        for call in [fathom.check, fathom.identify, fathom.diagnose, fathom.compare]:
            self.refuses("there is no such log", call, "no/such/log")
        self.refuses("no/model.json", fathom.read_model, "no/model.json")
        self.refuses("null character", fathom.open_log, "a\0b")

    def test_a_broken_cell_is_named(self):
        file = self.folder / "run.csv"
        file.write_text("t,tau,v\n0,1,2\n1,nan,2\n")
        self.refuses(r"run.csv:3: column 'tau'", fathom.open_log, file, dof="surge")
        self.refuses("does not say whose", fathom.open_log, file)

    def test_names_that_are_none(self):
        self.refuses("dof: is 'up'", fathom.identify, FLATFISH, dof="up")
        self.refuses("family: is 'best'", fathom.identify, FLATFISH, dof="surge", family="best")
        self.refuses("source: is", fathom.identify, FLATFISH, dof="surge", source="sonar")
        self.refuses("offset: is", fathom.identify, FLATFISH, dof="surge", offset="none")
        self.refuses("weighting: is", fathom.identify, FLATFISH, dof="surge", weighting="w")
        self.refuses("free: goes with", fathom.identify, FLATFISH, dofs=["surge"], free=["offset.surge"])
        self.refuses("structure: is", fathom.identify, FLATFISH, dofs=["surge"], structure="x")
        self.refuses("dofs: names surge twice", fathom.identify, FLATFISH, dofs=["surge"] * 2)
        self.refuses("dofs: is empty", fathom.identify, FLATFISH, dofs=[])
        self.refuses("families: is", fathom.compare, FLATFISH, families=["best"])

    def test_options_have_the_names_of_python(self):
        self.refuses("^correct: corrects 'p', which", fathom.open_log, FLATFISH, correct={"p": -1.0})
        self.refuses("^late: corrects 'p', which is no", fathom.open_log, FLATFISH, late={"p": 0.1})
        self.refuses(
            "^correct, late: corrects", fathom.open_log, FLATFISH, correct={"p": 2.0}, late={"u": 0.1}
        )
        self.refuses("^dof: is missing, and", fathom.identify, FLATFISH)
        file = self.folder / "run.csv"
        file.write_text("t,tau,v\n0,1,2\n1,1,2\n")
        self.refuses("expected dof with it: dof=surge", fathom.open_log, file)
        self.refuses("^velocity=v.csv: .* Leave out velocity.$", fathom.open_log, file, dof="surge", velocity="v.csv")
        self.refuses("^correct: corrects 'u', which is no speed", fathom.open_log, file, dof="surge", correct={"u": 2.0})
        # What is typed into a shell stays as it is typed.
        shutil.copytree(FLATFISH, self.folder / "logs" / "one")
        self.refuses(
            "expected one of them: log=.*one. fathom_check --archive=.* checks them all.",
            fathom.open_log,
            self.folder / "logs",
        )
        foreign = self.folder / "foreign.txt"
        foreign.write_text("a;b\n1;2\n")
        self.refuses("fathom_import --from=.* --suggest > map", fathom.open_log, foreign)

    def test_remarks_name_options_as_python_has_them(self):
        log = fathom.open_log(FLATFISH, held_out=[(9.01, 9.02)], correct={"u": 1.0}, late={"u": 0.1})
        self.assertIn("velocity.csv: u 0.1 s earlier, as correct, late says.", log.remarks)
        self.assertTrue(any(text.startswith("held_out: [") for text in log.remarks), log.remarks)

    def test_numbers_that_cannot_be(self):
        nan = float("nan")
        for bad in [-1.0, nan]:
            self.refuses("huber: is", fathom.identify, FLATFISH, dof="surge", huber=bad)
            self.refuses(
                "shooting_window: is", fathom.identify, FLATFISH, dof="surge", shooting_window=bad
            )
            self.refuses("window", fathom.identify, FLATFISH, dofs=["surge"], window=bad)
            self.refuses("effort: is", fathom.diagnose, FLATFISH, dof="surge", effort=bad)
            self.refuses(
                "false_alarm_rate: is", fathom.diagnose, FLATFISH, dof="surge", false_alarm_rate=bad
            )
        for bad in [[1.0], [0.1, 1, 1, 1, 1], [-0.1, 1, 1, 1, nan], [-0.1, 0, 1, 1, 1]]:
            self.refuses(
                "gains", fathom.identify, FLATFISH, dof="surge", family="adaptive", gains=bad
            )
        self.refuses("held_out: holds", fathom.open_log, FLATFISH, held_out=[(5, 5)])
        self.refuses("held_out: holds", fathom.open_log, FLATFISH, held_out=[(nan, 5)])
        self.refuses("decay_from: is", fathom.free_decay, FLATFISH, dof="surge", decay_from=nan)

    def test_options_of_the_other_kind(self):
        self.refuses("dof: goes with a model", fathom.identify, FLATFISH, dof="yaw", dofs=["yaw"])
        self.refuses("window: goes with dofs", fathom.identify, FLATFISH, dof="yaw", window=5.0)
        self.refuses("seed: goes with a model", fathom.diagnose, FLATFISH, dofs=["yaw"], seed=2)
        model = fathom.identify(FLATFISH, dof="surge", family="least_squares").model
        self.refuses("horizon: goes with", fathom.simulate, model, FLATFISH, horizon=5.0)

    def test_simulate_takes_what_identify_returns(self):
        surge = fathom.identify(FLATFISH, dof="surge", family="least_squares")
        ours = fathom.simulate(surge, FLATFISH)
        self.assertEqual(ours.to_dict(), fathom.simulate(surge.model, FLATFISH).to_dict())
        t = np.arange(0.0, 60.0, 0.1)
        command = {"t": t, "tau_surge": np.where(t < 30.0, 5.0, -5.0)}
        still = fathom.Log.from_arrays(command, {"t": t, "u": np.full(t.size, 0.3)}, dof="surge")
        unusable = fathom.identify(still, dof="surge")
        self.assertFalse(unusable.is_usable)
        self.refuses("usable", fathom.simulate, unusable, FLATFISH)

    def test_held_out_outside_the_log(self):
        self.refuses("held_out: 9000:9100 lies outside", fathom.open_log, FLATFISH, held_out=[(9000, 9100)])

    def test_arrays_that_are_no_streams(self):
        t, v = coasting()
        sound = {"t": t, "u": v}
        make = fathom.Log.from_arrays
        self.refuses(r"command.'tau_surge'.*200 values", make, {"t": t, "tau_surge": v[:200]}, sound, dof="surge")
        self.refuses("2 dimensions", make, None, {"t": t, "u": v.reshape(2, -1)}, dof="surge")
        self.refuses("no array of numbers", make, None, {"t": t, "u": ["a"] * t.size}, dof="surge")
        self.refuses("expected a finite number", make, None, {"t": t, "u": v * np.nan}, dof="surge")
        self.refuses("stamps that rise", make, None, {"t": t[::-1], "u": v}, dof="surge")
        self.refuses("has no \"t\"", make, None, {"u": v}, dof="surge")
        self.refuses("letters", make, None, {"t": t, "u,v": v}, dof="surge")
        self.refuses("expected a dict", make, None, [t, v], dof="surge")
        self.refuses("expected the vehicle's motion", make, {"t": t, "tau_surge": v}, dof="surge")
        self.refuses("dof", make, None, sound, dof="up")
        self.refuses("mass", make, None, sound, dof="surge", mass=-1.0)
        for size in [0, 1]:
            self.refuses("row", make, None, {"t": t[:size], "u": v[:size]}, dof="surge")

    def test_logs_that_lack_what_is_asked_for(self):
        t, v = coasting()
        decay = fathom.Log.from_arrays(None, {"t": t, "u": v}, dof="surge")
        self.refuses("free_decay", fathom.identify, decay)
        self.refuses("free_decay", fathom.diagnose, decay)
        self.refuses("", fathom.compare, decay)
        model = fathom.identify(FLATFISH, dof="yaw", family="least_squares").model
        self.refuses("", fathom.simulate, model, decay)
        self.refuses("", fathom.identify, FLATFISH, dof="roll")
        self.refuses("same data", fathom.identify, [FLATFISH, FLATFISH], dof="surge")
        self.refuses("empty list", fathom.identify, [])
        self.refuses("names several", fathom.check, [FLATFISH, decay])
        self.refuses("joint|detections|camera", fathom.identify, FLATFISH, dof="surge", family="joint")
        self.refuses("", fathom.identify, FLATFISH, dof="surge", source="camera")
        few = fathom.Log.from_arrays(
            {"t": t[:5], "tau_surge": v[:5]}, {"t": t[:5], "u": v[:5]}, dof="surge"
        )
        for call in [fathom.identify, fathom.diagnose, fathom.compare, fathom.free_decay]:
            try:
                result = call(few)
            except ValueError:
                continue
            self.assertFalse(result.is_usable, call)
        fathom.check(few)

    def test_values_beyond_reason_and_tiny_windows_end_no_interpreter(self):
        model = fathom.identify(FLATFISH, dof="surge", family="least_squares").model
        t = 0.1 * np.arange(24)
        far = np.where(np.arange(24) % 7 == 0, 1e308, -1e308)  # no speed can be told
        pose = {"t": t, "x": 0 * t, "y": far, "z": far, "qx": 0 * t, "qy": 0 * t, "qz": 0 * t}
        sparse = fathom.Log.from_arrays(
            {"t": t, "tau_surge": t}, None, {**pose, "qw": 0 * t + 1}, dof="surge"
        )
        self.refuses("no stretch of its motion", fathom.simulate, model, sparse)
        both = fathom.identify(FLATFISH, dofs=["surge"], structure="diagonal").model
        for horizon in [1e-300, 1e-3, 0.15]:
            run = fathom.simulate(both, FLATFISH, horizon=horizon)
            self.assertEqual(run.velocity["surge"].shape, run.time.shape)

    def test_another_type_is_a_type_error(self):
        for call in [
            lambda: fathom.open_log(3),
            lambda: fathom.identify(None, dof="surge"),
            lambda: fathom.identify(FLATFISH, dof=3),
            lambda: fathom.simulate(3, FLATFISH),
            lambda: fathom.check(FLATFISH, 3),
            lambda: fathom.Log(),
        ]:
            self.assertRaises(TypeError, call)

    def test_a_fit_that_does_not_work_says_so(self):
        t = np.arange(0.0, 60.0, 0.1)
        flat = {"t": t, "u": np.full(t.size, 0.3)}
        log = fathom.Log.from_arrays({"t": t, "tau_surge": np.full(t.size, 5.0)}, flat, dof="surge")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", fathom.FindingWarning)
            result = fathom.identify(log)
        self.assertFalse(result.is_usable)
        self.assertTrue(result.message)
        self.refuses("no usable model", result.to_dict)
        self.refuses("no usable model", lambda: result.model)
        repr(result), result._repr_html_()

    def test_a_red_finding_is_a_warning(self):
        log, streams = fathom.open_log(FLATFISH), {}
        streams["command"] = {"t": log.command["t"], "tau_surge": -log.command["tau_surge"]}
        streams["velocity"] = {"t": log.velocity["t"], "u": log.velocity["u"]}
        turned = fathom.Log.from_arrays(**streams, dof="surge")
        with self.assertWarns(fathom.FindingWarning):
            fathom.identify(turned)
        with warnings.catch_warnings():
            warnings.simplefilter("error", fathom.FindingWarning)
            self.assertRaises(fathom.FindingWarning, fathom.identify, turned)


class Process(unittest.TestCase):
    def test_a_thousand_calls_keep_no_memory(self):
        t, v = coasting()

        def call():
            log = fathom.Log.from_arrays(None, {"t": t, "u": v}, dof="surge")
            log.velocity, repr(log)
            try:
                fathom.open_log("no/such/log")
            except ValueError:
                pass

        def resident():
            text = pathlib.Path("/proc/self/status").read_text()
            return int(re.search(r"VmRSS:\s+(\d+) kB", text).group(1))

        for _ in range(100):
            call()
        before = resident()
        for _ in range(1000):
            call()
        # A log of these arrays takes 8 kB: kept, they were 8 MB.
        self.assertLess(resident() - before, 3000)

    def test_other_threads_run_meanwhile(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)

        ticker = threading.Thread(target=tick)
        ticker.start()
        begin = time.monotonic()
        fathom.compare(FLATFISH)
        end = time.monotonic()
        done.set()
        ticker.join()
        inside = [begin, *(at for at in ticks if begin < at < end), end]
        # Were the lock held, the longest silence would be nearly all of the call.
        self.assertLess(max(np.diff(inside)), 0.5 * (end - begin))

    def test_fits_in_several_threads_give_the_same(self):
        alone = fathom.identify(FLATFISH, dof="surge").to_dict()
        with concurrent.futures.ThreadPoolExecutor(3) as pool:
            fits = [pool.submit(fathom.identify, FLATFISH, dof="surge") for _ in range(3)]
            for fit in fits:
                self.assertEqual(fit.result().to_dict(), alone)

    def test_results_show_themselves(self):
        log = fathom.open_log(FLATFISH)
        for result in [
            log,
            fathom.check(log),
            fathom.identify(log, dof="surge"),
            fathom.identify(log, dof="surge").model,
            fathom.compare(log, dofs=["surge"], families=["least_squares"]),
            fathom.identify(log, dofs=["surge", "yaw"], structure="diagonal"),
        ]:
            self.assertGreater(len(repr(result).splitlines()), 2)
            if hasattr(result, "_repr_html_"):
                self.assertTrue(result._repr_html_().lstrip().startswith("<"))

    def test_the_stubs_name_what_the_module_has(self):
        stubs = ast.parse(pathlib.Path(fathom.__file__).with_suffix(".pyi").read_text())
        names = set()
        for node in stubs.body:
            if isinstance(node, ast.ClassDef):
                members = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
                runtime = {name for name in vars(getattr(fathom, node.name)) if name[:2] != "__"}
                self.assertEqual({name for name in members if name[:2] != "__"}, runtime, node.name)
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                names.add(node.name)
        self.assertEqual(names | {"__version__"}, set(fathom.__all__))

    def test_every_public_name_has_a_docstring(self):
        for name in fathom.__all__:
            if name != "__version__":
                self.assertTrue(getattr(fathom, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
