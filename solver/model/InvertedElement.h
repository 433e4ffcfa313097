// solver/model/InvertedElement.h - whether the displaced mesh is still one: no element turned inside out.
#pragma once

#include <string>

#include "core/AlignedVector.h"
#include "core/ThreadTeam.h"
#include "model/Model.h"

namespace squat::model {

// Place of the first element whose Jacobian is not positive at one of its displaced corners; empty where there is none.
// `displacement`: state layout [m], tied slaves and ghost stations filled. Elements under a defect whose nodes were
// moved are judged by their shape before that. A not-a-number counts as nothing here: look for it first.
// `team`: whose threads share the blocks; null: the calling thread alone.
std::string invertedElement(const Model& model, const AlignedVector& displacement, ThreadTeam* team = nullptr);

}  // namespace squat::model
