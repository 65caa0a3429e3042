// SPDX-License-Identifier: Apache-2.0
#include "report/html_style.h"

namespace dorsum {

std::string_view ReportStyle() {
  return R"css(:root {
  color-scheme: light dark;
  --page: #f6f5f2; --sheet: #ffffff; --ink: #23272b; --soft: #5d666e; --line: #dcdad4;
  --accent: #1f6f78;
  --good: #1d6b3a; --good-bg: #e0f2e6; --doubtful: #7a5200; --doubtful-bg: #fdf0cf; --bad: #9c1f1f;
  --bad-bg: #fbe3e1;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #16191c; --sheet: #1f2429; --ink: #e4e7ea; --soft: #a2acb5; --line: #363d44;
    --accent: #6cc5cf;
    --good: #8fdcaa; --good-bg: #17382a; --doubtful: #f2cf7a; --doubtful-bg: #3f3215;
    --bad: #ffaba5; --bad-bg: #471e1e;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", Arial, sans-serif;
}
main { max-width: 1240px; margin: 0 auto; padding: 2.2rem 1.4rem 1rem; }
header { border-bottom: 3px solid var(--accent); padding-bottom: 1rem; margin-bottom: 1.4rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .3rem; overflow-wrap: anywhere; }
h2 { font-size: 1.35rem; margin: 2.6rem 0 .5rem; }
h3 {
  font-size: 1.05rem; margin: 0 0 .4rem; display: flex; justify-content: space-between; gap: .8rem;
  align-items: center;
}
.part { display: inline-block; }
.part::first-letter, .card p::first-letter { text-transform: uppercase; }
p { max-width: 75ch; margin: .5rem 0; }
.subtitle, .intro, figcaption, caption { color: var(--soft); }
.subtitle { font-size: 1.08rem; margin: 0; }
.facts {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(165px, 1fr)); gap: .8rem;
  margin: 1.2rem 0;
}
.facts div {
  background: var(--sheet); border: 1px solid var(--line); border-radius: 10px;
  padding: .7rem .9rem;
}
.facts dt { font-size: .85rem; color: var(--soft); }
.facts dd {
  margin: 0; font-size: 1.35rem; font-weight: 600; font-variant-numeric: tabular-nums;
  overflow-wrap: anywhere;
}
.facts small { font-size: .85rem; font-weight: 400; color: var(--soft); }
.warnings {
  background: var(--doubtful-bg); color: var(--doubtful); border-left: 5px solid var(--doubtful);
  border-radius: 6px; padding: .8rem 1.1rem; margin: 1.2rem 0;
}
.warnings ul { margin: .3rem 0 0; padding-left: 1.2rem; color: var(--ink); }
.cards {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); gap: 1rem;
  margin: 1rem 0;
}
.card {
  background: var(--sheet); border: 1px solid var(--line); border-top: 4px solid;
  border-radius: 10px; padding: .9rem 1.1rem;
}
.card.good { border-top-color: var(--good); }
.card.doubtful { border-top-color: var(--doubtful); }
.card.bad { border-top-color: var(--bad); }
.card table { font-size: .9rem; }
.badge {
  font-size: .85rem; font-weight: 600; border-radius: 999px; padding: .1rem .7rem;
  white-space: nowrap;
}
.badge.good { background: var(--good-bg); color: var(--good); }
.badge.doubtful { background: var(--doubtful-bg); color: var(--doubtful); }
.badge.bad { background: var(--bad-bg); color: var(--bad); }
.figures {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr));
  gap: 1.2rem; margin: 1rem 0; align-items: start;
}
.figures.three { grid-template-columns: repeat(auto-fit, minmax(min(100%, 320px), 1fr)); }
figure {
  margin: 0; background: var(--sheet); border: 1px solid var(--line); border-radius: 10px;
  overflow: hidden;
}
figure.wide, figure:has(input:checked) { grid-column: 1 / -1; }
figure label { display: block; cursor: zoom-in; }
figure:has(input:checked) label { cursor: zoom-out; }
figure input { position: absolute; opacity: 0; pointer-events: none; }
figure label:focus-within { outline: 3px solid var(--accent); outline-offset: -3px; }
img { display: block; width: 100%; height: auto; background: #ffffff; }
figcaption { padding: .7rem 1rem .9rem; font-size: .93rem; }
figcaption strong { color: var(--ink); }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
.scroll table {
  width: auto; min-width: min(100%, 26rem); background: var(--sheet);
  border: 1px solid var(--line);
}
.scroll th, .scroll td { padding: .45rem .9rem; }
caption { text-align: left; padding: .2rem 0 .5rem; font-size: .93rem; }
th { text-align: left; font-size: .88rem; border-bottom: 2px solid var(--line); }
td {
  border-top: 1px solid var(--line); padding: .25rem .5rem .25rem 0; vertical-align: top;
  overflow-wrap: anywhere;
}
.n { text-align: right; }
td.n, .unit { white-space: nowrap; }
.bar {
  display: inline-block; width: 120px; height: .6rem; margin-left: .8rem; background: var(--line);
  border-radius: 3px; overflow: hidden;
}
.bar span { display: block; height: 100%; background: var(--accent); }
footer {
  max-width: 1240px; margin: 2rem auto 0; padding: 1rem 1.4rem 2rem; color: var(--soft);
  font-size: .88rem; border-top: 1px solid var(--line);
}
@media print {
  :root {
    color-scheme: light;
    --page: #ffffff; --sheet: #ffffff; --ink: #000000; --soft: #444444; --line: #cccccc;
    --accent: #1f6f78;
    --good: #1d6b3a; --good-bg: #ffffff; --doubtful: #7a5200; --doubtful-bg: #ffffff;
    --bad: #9c1f1f; --bad-bg: #ffffff;
  }
  body { font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  .badge { border: 1px solid; }
  .figures { grid-template-columns: 1fr 1fr; }
  .figures.three { grid-template-columns: 1fr 1fr 1fr; }
  figure, .card, tr, .facts div { break-inside: avoid; }
  h2 { break-after: avoid; }
}
)css";
}

}  // namespace dorsum
