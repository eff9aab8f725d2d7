#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace docent::update {

/// A file of a release, fetched by zchunk (zckdl and unzck of Debian's package zchunk): only those
/// chunks go over the wire that an older file lacks, compressed.
struct DeltaRequest {
  std::string url;               ///< Of the file; NAME.zck lies beside it.
  std::uint64_t most = 0;        ///< Bytes that the file may have.
  std::filesystem::path older;   ///< The .zck of an older release; may be missing.
  std::filesystem::path folder;  ///< Where it is unpacked; made, and emptied, by this.
};

/// The unpacked file and its .zck, in the request's folder.
struct DeltaFiles {
  std::filesystem::path file, zchunk;
};

/// Fetches it; false where that did not work: zchunk is not installed, there is no .zck, the server
/// gives no parts of files. Then the whole file is fetched instead. What comes is not trusted:
/// whoever asks verifies it.
bool fetch_delta(const DeltaRequest& request, DeltaFiles& files);

}  // namespace docent::update
