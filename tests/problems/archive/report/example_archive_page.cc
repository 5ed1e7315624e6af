// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// example_archive_page PAGE.html [DIVES [LOGS_PER_DIVE]]: the page of the made-up archive, to be
// looked at.

#include "fathom/archive/report/archive_page.h"
#include "fathom/base/files/output_file.h"

#include <cstdlib>

#include "example_archive.h"

int main(int argc, char** argv) {
  if (argc < 2) return EXIT_FAILURE;
  fathom::ExampleArchiveOptions options;
  if (argc > 2) options.num_dives = std::atoi(argv[2]);
  if (argc > 3) options.logs_per_dive = std::atoi(argv[3]);
  fathom::WriteFile(argv[1], fathom::RenderArchivePage(fathom::ExampleArchive(options)));
  return EXIT_SUCCESS;
}
