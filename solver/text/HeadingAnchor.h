// solver/text/HeadingAnchor.h - the name by which a link of a Markdown page knows a heading.
#pragma once

#include <string>
#include <string_view>

namespace squat::text {

// As GitHub makes it: "Parts of other work" -> "parts-of-other-work"; signs but hyphen and underscore are left out.
std::string headingAnchor(std::string_view heading);

}  // namespace squat::text
