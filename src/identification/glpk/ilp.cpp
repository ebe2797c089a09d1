// SPDX-License-Identifier: MIT
// The labelled geometric graph distance as the integer linear program of the thesis (Eq. 4.3–4.7), solved by
// GLPK.
//
// The only file that touches GLPK (GPL-3+). Columns in a fixed order: V_uv (u outer, v inner), then E_ee' (e
// outer); rows: Eq. 4.4, Eq. 4.5, then the constraints on the edges. Two formulations with one optimum:
// literal, Eq. 4.6 as printed, E ≤ ½ (V_uu' + V_vv' + V_uv' + V_vu'), right for integers and weak as a
// relaxation; tightened, E ≤ V_uu'+V_uv', E ≤ V_vv'+V_vu', E ≤ V_uu'+V_vu', E ≤ V_uv'+V_vv', and Σ_e' E_ee' ≤
// 1 on both sides.
#include <glpk.h>

#include <memory>
#include <tuple>

#include "identification/labelled_graph.hpp"
#include "pantin/error.hpp"

namespace pantin {
namespace {

// Closes GLPK's environment of this thread, so that nothing stays allocated.
struct Environment {
    Environment() { glp_term_out(GLP_OFF); }
    ~Environment() { glp_free_env(); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
};

// Ends the search after a number of subproblems.
struct Countdown {
    long left = 0;

    static void tick(glp_tree* tree, void* info) {
        if (glp_ios_reason(tree) == GLP_IPREPRO && static_cast<Countdown*>(info)->left-- <= 0)
            glp_ios_terminate(tree);
    }
};

class Program {
public:
    Program(const LabelledGraph& a, const LabelledGraph& b, const GgdOptions& options,
            IlpFormulation formulation)
        : a_(a), b_(b), problem_(glp_create_prob(), glp_delete_prob) {
        glp_set_obj_dir(problem_.get(), GLP_MIN);
        for (int u = 0; u < vertices(a); ++u)
            for (int v = 0; v < vertices(b); ++v) add_binary(vertex_cost(a, u, b, v, options));
        for (const auto& e : a.edges)
            for (const auto& f : b.edges) // −K_e (|e| + |e'| − ||e| − |e'||)
                add_binary(-2 * options.k_e * std::min(edge_length(a, e), edge_length(b, f)));
        add_matching_rows();
        if (formulation == IlpFormulation::literal)
            add_literal_edge_rows();
        else
            add_tightened_edge_rows();
    }

    // The matching, and whether it is known to be the best to within the gap.
    std::pair<std::vector<std::pair<int, int>>, bool> solve(const IlpLimits& limits) {
        glp_iocp parameters;
        glp_init_iocp(&parameters);
        parameters.msg_lev = GLP_MSG_OFF;
        parameters.presolve = GLP_ON;
        parameters.mip_gap = limits.gap;
        parameters.tol_obj = 1e-11; // the default, 1e-7, may stop that far from the optimum
        Countdown countdown{limits.iterations};
        if (limits.iterations > 0) {
            parameters.cb_func = Countdown::tick;
            parameters.cb_info = &countdown;
        }
        const int outcome = glp_intopt(problem_.get(), &parameters);
        const int status = glp_mip_status(problem_.get());
        const bool proven = outcome == 0 ? status == GLP_OPT : outcome == GLP_EMIPGAP;
        if (!proven && outcome != GLP_ESTOP)
            throw Error(ErrorKind::internal, "GLPK found no optimum of the graph distance");
        std::vector<std::pair<int, int>> pairs;
        if (proven || status == GLP_FEAS)
            for (int u = 0; u < vertices(a_); ++u)
                for (int v = 0; v < vertices(b_); ++v)
                    if (glp_mip_col_val(problem_.get(), vertex_column(u, v)) > 0.5) pairs.emplace_back(u, v);
        return {std::move(pairs), proven};
    }

private:
    static int vertices(const LabelledGraph& graph) { return static_cast<int>(graph.positions.size()); }
    int vertex_column(int u, int v) const { return 1 + u * vertices(b_) + v; }
    int edge_column(int e, int f) const {
        return 1 + vertices(a_) * vertices(b_) + e * static_cast<int>(b_.edges.size()) + f;
    }
    void add_binary(double cost) {
        const int column = glp_add_cols(problem_.get(), 1);
        glp_set_col_kind(problem_.get(), column, GLP_BV);
        glp_set_obj_coef(problem_.get(), column, cost);
    }
    // Σ coefficient · column ≤ bound.
    void add_row(const std::vector<std::pair<int, double>>& terms, double bound) {
        std::vector<int> columns = {0};
        std::vector<double> values = {0}; // GLPK counts from 1
        for (const auto& [column, value] : terms) {
            columns.push_back(column);
            values.push_back(value);
        }
        const int row = glp_add_rows(problem_.get(), 1);
        glp_set_row_bnds(problem_.get(), row, GLP_UP, 0, bound);
        glp_set_mat_row(problem_.get(), row, static_cast<int>(terms.size()), columns.data(), values.data());
    }
    void add_matching_rows() {
        for (int u = 0; u < vertices(a_); ++u) { // Eq. 4.4
            std::vector<std::pair<int, double>> terms;
            for (int v = 0; v < vertices(b_); ++v) terms.emplace_back(vertex_column(u, v), 1);
            add_row(terms, 1);
        }
        for (int v = 0; v < vertices(b_); ++v) { // Eq. 4.5
            std::vector<std::pair<int, double>> terms;
            for (int u = 0; u < vertices(a_); ++u) terms.emplace_back(vertex_column(u, v), 1);
            add_row(terms, 1);
        }
    }
    void add_literal_edge_rows() {
        for (int e = 0; e < std::ssize(a_.edges); ++e)
            for (int f = 0; f < std::ssize(b_.edges); ++f) {
                const auto [u, v] = a_.edges[e];
                const auto [s, t] = b_.edges[f];
                add_row({{edge_column(e, f), 1},
                         {vertex_column(u, s), -0.5},
                         {vertex_column(v, t), -0.5},
                         {vertex_column(u, t), -0.5},
                         {vertex_column(v, s), -0.5}},
                        0); // Eq. 4.6
            }
    }
    void add_tightened_edge_rows() {
        const int edges_a = static_cast<int>(a_.edges.size()), edges_b = static_cast<int>(b_.edges.size());
        for (int e = 0; e < edges_a; ++e)
            for (int f = 0; f < edges_b; ++f) {
                const auto [u, v] = a_.edges[e];
                const auto [s, t] = b_.edges[f];
                const int us = vertex_column(u, s), ut = vertex_column(u, t);
                const int vs = vertex_column(v, s), vt = vertex_column(v, t);
                for (const auto& [first, second] : {std::pair{us, ut}, {vt, vs}, {us, vs}, {ut, vt}})
                    add_row({{edge_column(e, f), 1}, {first, -1}, {second, -1}}, 0);
            }
        for (int e = 0; e < edges_a; ++e) {
            std::vector<std::pair<int, double>> terms;
            for (int f = 0; f < edges_b; ++f) terms.emplace_back(edge_column(e, f), 1);
            add_row(terms, 1);
        }
        for (int f = 0; f < edges_b; ++f) {
            std::vector<std::pair<int, double>> terms;
            for (int e = 0; e < edges_a; ++e) terms.emplace_back(edge_column(e, f), 1);
            add_row(terms, 1);
        }
    }

    const LabelledGraph& a_;
    const LabelledGraph& b_;
    std::unique_ptr<glp_prob, void (*)(glp_prob*)> problem_;
};

} // namespace

bool ilp_available() { return true; }

GgdResult geometric_graph_distance_ilp(const LabelledGraph& a, const LabelledGraph& b,
                                       const GgdOptions& options, IlpFormulation formulation,
                                       const IlpLimits& limits) {
    GgdResult result;
    result.base = empty_matching_cost(a, b, options);
    if (!a.positions.empty() && !b.positions.empty()) {
        const Environment environment;
        std::tie(result.pairs, result.optimal) = Program(a, b, options, formulation).solve(limits);
    }
    result.distance = matching_cost(a, b, result.pairs, options);
    return result;
}

} // namespace pantin
