#include "verify/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace washtub {
namespace {

constexpr const char* style =
    R"(:root{color-scheme:light dark;--line:#ccc;--soft:#f3f3f3;--good:#1a7f43;
--bad:#c62828;--dim:#666}
@media(prefers-color-scheme:dark){:root{--line:#444;--soft:#222;--good:#5cc98a;--bad:#ff7b72;--dim:#999}}
body{font:15px/1.45 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;background:Canvas;
color:CanvasText}
table{border-collapse:collapse;width:100%;margin:.8em 0;font-size:14px}
th,td{text-align:left;padding:.25em .6em;border-bottom:1px solid var(--line);vertical-align:top}
th{background:var(--soft)}td.n{white-space:nowrap;font-variant-numeric:tabular-nums}
.pass{color:var(--good)}.miss{color:var(--bad);font-weight:bold}.informative,.notrun,.dim{color:var(--dim)}
figure{margin:1.2em 0}figcaption{color:var(--dim)}svg{max-width:100%;height:auto}
h2{margin-top:2.2em;border-bottom:2px solid var(--line)}code{font-size:13px;overflow-wrap:anywhere}
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') result += "&amp;";
    if (c == '<') result += "&lt;";
    if (c == '>') result += "&gt;";
    if (c == '"') result += "&quot;";
    if (c != '&' && c != '<' && c != '>' && c != '"') result += c;
  }
  return result;
}

const char* css_class(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::miss:
    case Verdict::known_miss:
      return "miss";
    case Verdict::informative:
      return "informative";
    case Verdict::not_run:
      return "notrun";
  }
  return "";
}

std::string quantities(const CaseReport& c) {
  std::string html =
      "<table><tr><th>quantity<th>measured<th>reference<th>deviation<th>verdict<th>source</tr>\n";
  for (std::size_t i = 0; i < c.judgements.size(); ++i) {
    const Row r = row(c, i);
    const Judgement& j = c.judgements[i];
    const std::string note = j.note.empty() ? "" : "<br><b>" + escaped(j.note) + "</b>";
    html += fmt::format(
        "<tr><td>{}<td class=n>{}<td class=n>{}<td class=n>{}<td class={}>{}<td>{}{}</tr>\n",
        escaped(r.quantity), escaped(r.measured), escaped(r.reference), escaped(r.deviation),
        css_class(j.verdict), r.verdict, escaped(c.made.expected.quantities[i].source), note);
  }
  return html + "</table>\n";
}

std::string runs(const CaseReport& c) {
  std::string html = "<table><tr><th>run<th>state<th>wall time<th>command</tr>\n";
  for (std::size_t i = 0; i < c.made.runs.size(); ++i) {
    const RunResult& run = c.made.runs[i];
    const RunSpec& spec = c.made.expected.runs[i];
    std::string words;
    for (const auto& word : run_words(c.made.expected, spec, run.directory))
      words += word.find(' ') == std::string::npos ? " " + word : " '" + word + "'";
    html += fmt::format(
        "<tr><td>{}<td>{}{}<td class=n>{}<td><code>washtub{}</code></tr>\n", escaped(spec.name),
        name(run.state), run.error.empty() ? "" : ": " + escaped(run.error),
        std::isnan(run.wall) ? "-" : fmt::format("{:.1f} s", run.wall), escaped(words));
  }
  return html + "</table>\n";
}

std::string figures(const CaseReport& c) {
  std::string html;
  for (std::size_t i = 0; i < c.figures.size(); ++i) {
    const Drawn& drawn = c.figures[i];
    html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                        drawn.svg.empty() ? "<p>" + escaped(drawn.note) + "</p>" : drawn.svg,
                        escaped(c.made.expected.figures[i].caption));
  }
  return html;
}

/// One line per case: its worst verdict.
std::string contents(const Report& report) {
  std::string html =
      "<table><tr><th>case<th>pass<th>miss<th>known miss<th>informative<th>not run</tr>\n";
  for (const CaseReport& c : report.cases) {
    std::array<int, 5> n{};
    for (const Judgement& j : c.judgements) ++n[static_cast<std::size_t>(j.verdict)];
    html += fmt::format(
        "<tr><td><a href=\"#{0}\">{1}</a><td>{2}<td class={7}>{3}<td>{4}<td>{5}<td>{6}</tr>\n",
        c.made.expected.name, escaped(c.made.expected.title), n[0], n[1], n[2], n[3], n[4],
        n[1] > 0 ? "miss" : "pass");
  }
  return html + "</table>\n";
}

}  // namespace

std::string report_page(const Report& report) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
      "content=\"width=device-width\"><title>Verification of Washtub</title><style>{}</style>"
      "</head><body>\n<h1>Verification</h1>\n<p>{}, level {}: {}.</p>\n"
      "<p class=dim>A verdict compares what the program computes with a reference and a tolerance "
      "whose source stands beside them. Informative quantities are shown and never decide.</p>\n",
      style, escaped(report.program), report.level == VerifyLevel::quick ? "quick" : "full",
      summary_line(report));
  html += contents(report);
  for (const CaseReport& c : report.cases)
    html += fmt::format("<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n", c.made.expected.name,
                        escaped(c.made.expected.title), escaped(c.made.expected.about)) +
            quantities(c) + figures(c) + runs(c);
  return html + "</body></html>\n";
}

}  // namespace washtub
