// compare: what differs between two results, the differences first.
#include <cstdio>

#include "app/verbs.h"
#include "compare/compare.h"
#include "compare/comparison_json.h"
#include "compare/junit.h"
#include "io/write_file.h"

namespace drape {

namespace {

void print(const Comparison& comparison) {
    constexpr size_t most_lines = 20;
    size_t told = 0;
    for (const Compared& file : comparison.files) {
        if (file.why.empty()) continue;
        if (told++ < most_lines)
            std::printf("%s: %s: %s\n", file.name.c_str(), std::string(verdict_name(file.verdict)).c_str(),
                        file.why.c_str());
    }
    if (told > most_lines) std::printf("and %zu more\n", told - most_lines);
    std::string counts;
    for (const Verdict verdict :
         {Verdict::identical, Verdict::within, Verdict::different, Verdict::missing, Verdict::added})
        if (const int count = comparison.count(verdict); count > 0)
            counts += cat(counts.empty() ? "" : ", ", count, " ", verdict_name(verdict));
    std::printf("%s: %s\n", comparison.passed() ? "same" : "different", counts.c_str());
    if (const std::string cause = cause_of(comparison); !cause.empty()) std::printf("%s\n", cause.c_str());
}

}  // namespace

Exit compare_results(const CompareRequest& request) {
    Asked asked{.perceptual = request.perceptual, .hausdorff = request.hausdorff};
    for (const std::string& limit : request.limits) add_limit(asked.limits, limit);
    for (const std::string& rectangle : request.ignore) asked.ignore.push_back(rectangle_of(rectangle));
    const Comparison comparison = compare(request.result, request.reference, asked);
    if (!request.json.empty()) write_file(request.json, comparison_json(comparison));
    if (!request.junit.empty()) write_file(request.junit, junit_report(comparison, request.reference));
    if (!request.quiet) print(comparison);
    return comparison.passed() ? Exit::done : Exit::different;
}

}  // namespace drape
