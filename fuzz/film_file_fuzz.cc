// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a film, whose camera, tags and mount are those of data/films.

#include "fathom/base/input_error.h"
#include "fathom/film/film_file.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  fathom::Film film;
  try {
    film = fathom::ParseFilmFile(FATHOM_DATA_DIR "/films/fuzzed.yaml", text);
  } catch (const fathom::InputError&) {
    return 0;
  }
  if (!(film.sampling.rate > 0.0 && film.exposure * film.sampling.rate <= 1.0)) std::abort();
  if (!(film.corner_sigma >= 0.0 && std::isfinite(film.corner_sigma))) std::abort();
  return 0;
}
