#include "segmentation/model.hpp"

#include <algorithm>

#include "pantin/segmentation.hpp"

namespace pantin::segmentation {

Features Stem::forward(const Tensor& ink, const Runtime& runtime) const {
    Features features;
    for (std::size_t i = 0; i < down.size(); ++i) {
        const Tensor& x = i == 0 ? ink : features.stages.back();
        features.stages.push_back(res[i].forward(down[i].forward(x, runtime), runtime));
    }
    return features;
}

Tensor Router::forward(const Features& features, const Runtime& runtime) const {
    const Tensor& coarsest = features.stages.back();
    const Tensor pooled = network::concatenate(network::global_average_pool(coarsest), // [224, 1, 1]
                                               network::global_max_pool(coarsest));
    const Tensor scores = linear.forward(pooled, runtime);
    return network::softmax(scores, runtime);
}

Tensor PoseHead::forward(const Features& features, const Runtime& runtime) const {
    const Tensor x = conv.forward(features.stages.back(), runtime);
    const Tensor scores = linear.forward(network::global_average_pool(x), runtime);
    return network::softmax(scores, runtime);
}

Tensor Expert::forward(const Features& features, const Runtime& runtime) const {
    Tensor x = network::forward(context, features.stages.back(), runtime);
    for (std::size_t i = 0; i < decoder.size(); ++i) {
        const Tensor& skip = features.stages[features.stages.size() - 2 - i];
        const Tensor doubled = network::resize_bilinear(x, 2 * x.height(), 2 * x.width(), runtime);
        x = decoder[i].up.forward(network::concatenate(doubled, skip), runtime);
        x = network::forward(decoder[i].refine, x, runtime);
    }
    return network::softmax(logits.forward(x, runtime), runtime);
}

namespace {

void take_mean(Tensor& a, const Tensor& b) {
    std::transform(a.begin(), a.end(), b.begin(), a.begin(), [](float x, float y) { return 0.5f * (x + y); });
}

// Directions of a mirrored drawing as those of the drawing: E and W exchange, N and S stay.
Tensor mirrored_pose(const Tensor& pose) {
    Tensor result = pose;
    for (std::size_t i = 0; i < pose_names.size(); ++i) {
        std::string name = pose_names[i];
        for (char& c : name) c = c == 'E' ? 'W' : c == 'W' ? 'E' : c;
        const auto other = std::find(pose_names.begin(), pose_names.end(), name) - pose_names.begin();
        result.begin()[other] = pose.begin()[i];
    }
    return result;
}

} // namespace

NetworkResult Network::forward(const Tensor& ink, const Runtime& runtime, int expert, bool mirror) const {
    NetworkResult result;
    const Features features = stem.forward(ink, runtime);
    const Features other = mirror ? stem.forward(network::mirrored(ink), runtime) : Features{};
    result.router = router->forward(features, runtime);
    result.pose = pose->forward(features, runtime);
    if (mirror) {
        take_mean(result.router, router->forward(other, runtime));
        take_mean(result.pose, mirrored_pose(pose->forward(other, runtime)));
    }
    result.expert = expert;
    if (expert < 0) {
        result.expert = 0;
        for (int e = 1; e < result.router.channels(); ++e)
            if (result.router(0, e, 0, 0) > result.router(0, result.expert, 0, 0)) result.expert = e;
    }
    const Expert& chosen = experts[static_cast<std::size_t>(result.expert)];
    result.parts = chosen.forward(features, runtime);
    if (mirror) take_mean(result.parts, network::mirrored(chosen.forward(other, runtime)));
    return result;
}

} // namespace pantin::segmentation
