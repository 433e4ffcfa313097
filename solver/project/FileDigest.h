// solver/project/FileDigest.h - whether a file of any size is the one that it was, without reading all of it.
#pragma once

#include <string>

namespace squat::project {

// Eight hexadecimal digits that stand for the size of a file and for its first and last MB, wherever it is: a copy has
// the same. For long records of tens of GB, of which recordDigest() would have to read everything. Notices another
// record, another head, and whatever was appended, cut off or converted; in files of up to 2 MB, everything. Does not
// notice values that were changed in their places between the first and the last MB. A file that was written anew with
// the same values counts as changed where its bytes have. Empty: not a file that can be read; throws nothing.
std::string fileDigest(const std::string& path);

// "PATH holds other values than when the project was saved"; empty where the digests agree or one is not known.
std::string changeOf(const std::string& path, const std::string& saved, const std::string& now);

}  // namespace squat::project
