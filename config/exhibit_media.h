#pragma once

#include <optional>
#include <vector>

#include "config/museum_config.h"
#include "config/museum_path.h"

namespace docent::config {

/// Looks whether the files of `captions` and `spoken` are there, in languages that the museum has;
/// puts what the files of `more_file` hold among the texts of `more`, and looks whether exhibits
/// with further pictures have a first one (with a [source] that is known only once its objects are
/// read), and no more than one leafs through. Looks whether each sound has a recording, and whether
/// an exhibit's own shape is told one way and completely. Appends what cannot be: a file that is
/// not there, or is no text in UTF-8; a text that is given twice.
void read_exhibit_media(MuseumConfig& config, MuseumPaths& paths,
                        std::vector<Diagnostic>& diagnostics);

/// That an exhibit has further pictures and no first one, from which one leafs on to them.
std::optional<Diagnostic> missing_first_picture(const MuseumConfig& config,
                                                const ExhibitSection& exhibit);

}  // namespace docent::config
