#include "compare/junit.h"

#include "base/error.h"
#include "base/markup.h"

namespace drape {

std::string junit_report(const Comparison& comparison, const std::string& suite) {
    const int passed = comparison.count(Verdict::identical) + comparison.count(Verdict::within);
    const size_t all = comparison.files.size();
    const std::string counts =
        cat(" tests=\"", all, "\" failures=\"", all - static_cast<size_t>(passed), "\" errors=\"0\"");
    std::string xml = cat("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites", counts,
                          ">\n  <testsuite name=\"", escaped(suite), "\"", counts, " skipped=\"0\">\n");
    for (const Compared& file : comparison.files) {
        xml += cat("    <testcase classname=\"", escaped(suite), "\" name=\"", escaped(file.name), "\"");
        if (file.passed())
            xml += "/>\n";
        else
            xml += cat("><failure type=\"", verdict_name(file.verdict), "\" message=\"", escaped(file.why),
                       "\"/></testcase>\n");
    }
    return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace drape
