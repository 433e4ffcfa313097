// app/manual/HtmlManual.h - the whole manual as one HTML file that needs no other.
#pragma once

#include <filesystem>
#include <string>

namespace squat::manual {

// The index page, then every page (.md) that it links to, in that order; a page that does not stand where the link says
// is looked for in `generated`. Links between pages become links within the file, pictures are part of it, other files
// that pages link to are appended as text. Throws std::runtime_error naming page and target where a link, an anchor or
// a picture leads nowhere.
std::string htmlManual(const std::filesystem::path& index, const std::filesystem::path& generated,
                       const std::string& version);

}  // namespace squat::manual
