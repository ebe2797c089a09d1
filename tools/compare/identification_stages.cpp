#include "compare.hpp"

namespace pantin::compare {

void identification_stages(const std::filesystem::path&, const std::vector<Figure>&, Report&) {}

} // namespace pantin::compare
