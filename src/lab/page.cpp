#include "lab/page.h"

#include "base/error.h"
#include "base/markup.h"
#include "study/html.h"

namespace drape {

namespace {

std::string chapter_text(const LabChapter& chapter) {
    const LabResult& result = chapter.result;
    const std::string name(chapter.experiment->name);
    std::string body;
    for (const std::string& text : result.story) body += paragraph(text);
    for (size_t i = 0; i < chapter.svg.size(); ++i)
        body += figure_of(chapter.svg[i], cat(name, i, "_"), result.figures[i].caption);
    for (const LabTable& rows : result.tables) body += table(rows.head, rows.rows, rows.words);
    std::string files;
    for (const LabCsv& csv : result.csv) files += cat(files.empty() ? "" : ", ", csv.file, ".csv");
    return section(cat(name, ": ", chapter.experiment->summary),
                   body + paragraph(cat("In numbers, beside this page: ", files, ".")));
}

}  // namespace

std::string lab_page(const std::vector<LabChapter>& chapters, const std::string& plot_trouble,
                     const Provenance& provenance) {
    std::string body = "<ul class=\"answer\">\n";
    for (const LabChapter& chapter : chapters)
        body += "<li>" + escaped(cat(chapter.experiment->name, ": ", chapter.result.claim)) + "</li>\n";
    body += "</ul>\n";
    if (!plot_trouble.empty()) body += paragraph(cat("No plots: ", plot_trouble, "."));
    for (const LabChapter& chapter : chapters) body += chapter_text(chapter);
    body +=
        section("How it was made",
                "<p><code>" + escaped(provenance.command) + "</code></p>" +
                    paragraph(cat("drape ", provenance.drape_version, "; gnuplot ",
                                  provenance.gnuplot_version.empty() ? "none" : provenance.gnuplot_version,
                                  ". The same figures on every run.")));
    return html_page("The spring laboratory", "cloth as masses and springs",
                     "what lecture notes claim, measured", body);
}

}  // namespace drape
