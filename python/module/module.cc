// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The Python module fathom._fathom: docs/python.md. Each file beside this one binds one question.

#include "fathom/base/input_error.h"

#include <exception>

#include "module/bindings.h"
#include "module/python_words.h"
#include <glog/logging.h>

namespace py = pybind11;

PYBIND11_MODULE(_fathom, module) {
  module.doc() = "Motion models of underwater vehicles from their logs.";
  module.attr("__version__") = FATHOM_VERSION;

  // What a solver tries and drops is no news to a user. A caller's own glog, if there is one, stays
  // as it is.
  if (!google::IsGoogleLoggingInitialized()) {
    FLAGS_logtostderr = true;
    FLAGS_minloglevel = google::GLOG_FATAL;
    google::InitGoogleLogging("fathom");
  }

  // What cannot be used is a ValueError with the same sentence as a tool's, but for the dashes.
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const fathom::InputError& input_error) {
      PyErr_SetString(PyExc_ValueError, fathom::InPythonWords(input_error.what()).c_str());
    }
  });
  module.add_object("FindingWarning",
                    PyErr_NewExceptionWithDoc("fathom.FindingWarning",
                                              "A red finding: no model of this log should be "
                                              "believed before it is explained.",
                                              PyExc_UserWarning,
                                              nullptr));

  // The page writes the signatures; pybind11's would show C++.
  py::options options;
  options.disable_function_signatures();
  fathom::BindValues(module);
  fathom::BindLog(module);
  fathom::BindModels(module);
  fathom::BindCheck(module);
  fathom::BindIdentify(module);
  fathom::BindCoupled(module);
  fathom::BindCompare(module);
  fathom::BindSimulate(module);
  fathom::BindDiagnose(module);
  fathom::BindFreeDecay(module);
  fathom::BindTrajectory(module);
  fathom::BindTrack(module);
  fathom::BindRefine(module);
}
