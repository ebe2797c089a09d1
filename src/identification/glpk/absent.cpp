// SPDX-License-Identifier: MIT
// Built without GLPK (`make GLPK=0`): the exact branch and bound serves alone.
#include "pantin/error.hpp"
#include "pantin/identification.hpp"

namespace pantin {

bool ilp_available() { return false; }

GgdResult geometric_graph_distance_ilp(const LabelledGraph&, const LabelledGraph&, const GgdOptions&,
                                       IlpFormulation, const IlpLimits&) {
    throw Error(ErrorKind::usage,
                "this program was built without GLPK: the integer linear program cannot be solved");
}

} // namespace pantin
