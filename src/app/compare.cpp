// compare: what differs between two results, the differences first.
#include <cstdio>

#include "app/verbs.h"
#include "app/version.h"
#include "base/plain_line.h"
#include "base/shell_word.h"
#include "compare/accept.h"
#include "compare/compare.h"
#include "compare/comparison_json.h"
#include "compare/junit.h"
#include "compare/page.h"
#include "io/write_file.h"

namespace drape {

namespace {

void print(const Comparison& comparison) {
    constexpr size_t most_lines = 20;
    size_t told = 0;
    for (const Compared& file : comparison.files) {
        if (file.why.empty()) continue;
        if (told++ < most_lines)
            std::printf("%s: %s: %s\n", plain_line(file.name).c_str(),
                        std::string(verdict_name(file.verdict)).c_str(), file.why.c_str());
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

// The command that makes these results the references.
std::string accept_command(const CompareRequest& request) {
    std::string command =
        cat("drape compare ", shell_word(request.result), " ", shell_word(request.reference));
    for (const std::string& limit : request.limits) command += " --limit " + shell_word(limit);
    for (const std::string& rectangle : request.ignore) command += " --ignore " + shell_word(rectangle);
    return command + " --accept";
}

}  // namespace

Exit compare_results(const CompareRequest& request) {
    Asked asked{.perceptual = request.perceptual, .hausdorff = request.hausdorff};
    for (const std::string& limit : request.limits) add_limit(asked.limits, limit);
    for (const std::string& rectangle : request.ignore) asked.ignore.push_back(rectangle_of(rectangle));
    const Comparison comparison = compare(request.result, request.reference, asked);
    if (!request.json.empty()) write_file(request.json, comparison_json(comparison));
    if (!request.junit.empty()) write_file(request.junit, junit_report(comparison, request.reference));
    if (!request.html.empty())
        write_file(request.html,
                   comparison_page(comparison, {request.result, request.reference, asked,
                                                accept_command(request), cat("drape ", version)}));
    if (!request.quiet) print(comparison);
    if (request.accept) {
        accept(comparison, request.result, request.reference);
        if (!request.quiet && !comparison.passed())
            std::printf("accepted: %s is now the same\n", request.reference.c_str());
        return Exit::done;
    }
    if (!request.quiet && !comparison.passed())
        std::printf("to accept: %s\n", accept_command(request).c_str());
    return comparison.passed() ? Exit::done : Exit::different;
}

}  // namespace drape
