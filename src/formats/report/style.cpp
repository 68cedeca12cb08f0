#include "formats/report/pages.hpp"

namespace spectralpack {
namespace {

// Heights of rows are those that the pages are filled by (part_list.cpp, removal_order.cpp, top_views.cpp).
constexpr const char* kStyle = R"css(
@page { size: A4; margin: 10mm 10mm 10mm 16mm; }          /* 16 mm on the left: room for holes or a clip */
:root { --text: #171b21; --text-2: #4a5360; --text-3: #616b79; --line: #c9ced6; --line-2: #858e9b; --quiet: #f3f4f6; --accent: #2a5bd7; --ok: #17704a; --warn: #805200; --bad: #b3261e; --plot: #aab6cc; color-scheme: light; }
* { box-sizing: border-box; margin: 0; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
body { font: 400 8.6pt/1.32 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Helvetica Neue", Arial, sans-serif; color: var(--text); font-variant-numeric: tabular-nums; }
h1 { font-size: 19pt; line-height: 1.1; font-weight: 600; letter-spacing: -.015em; } h2 { font-size: 9.6pt; font-weight: 600; margin-bottom: 1.5mm; } h2 small { font-weight: 400; color: var(--text-2); font-size: 8pt; margin-left: 1.5mm; }
b { font-weight: 600; } svg, img { display: block; } table { border-collapse: collapse; width: 100%; } th { font-weight: 400; color: var(--text-2); text-align: left; font-size: 7.4pt; padding: 0 1.4mm 1mm; border-bottom: .35mm solid var(--text); vertical-align: bottom; } thead { display: table-header-group; }
.page { width: 184mm; height: 276mm; display: flex; flex-direction: column; break-after: page; overflow: hidden; } .page:last-child { break-after: auto; }
tr, figure, .slab, .left, .sign, .verdict { break-inside: avoid; }
.foot { margin-top: auto; padding-top: 2mm; color: var(--text-2); font-size: 8pt; } .foot b { color: var(--text); }

/* heads */
.title { display: grid; grid-template-columns: 1fr auto; align-items: end; border-bottom: .7mm solid var(--text); padding-bottom: 2mm; position: relative; } .title h1 { overflow: hidden; white-space: nowrap; text-overflow: ellipsis; } .title > div { min-width: 0; } .title p { color: var(--text-2); font-size: 9pt; margin-top: .6mm; } .title .trayno { font-size: 15pt; line-height: 1; padding-bottom: 5mm; } .title .trayno b { font-size: 24pt; } .title .pg { position: absolute; right: 0; bottom: 2mm; color: var(--text-2); font-size: 8pt; }
.run { display: flex; gap: 4mm; align-items: baseline; border-bottom: .7mm solid var(--text); padding-bottom: 1.4mm; margin-bottom: 3mm; font-size: 9pt; } .run b { font-size: 11pt; } .run .t { font-weight: 600; font-size: 11pt; margin-left: auto; } .run .pg { color: var(--text-2); }
.meta { display: flex; gap: 4mm; justify-content: space-between; padding: 2.2mm 0; border-bottom: .25mm solid var(--line); } .meta dt { color: var(--text-2); font-size: 7.4pt; } .meta div { min-width: 0; } .meta dt, .meta dd { white-space: nowrap; overflow: hidden; text-overflow: ellipsis; } .meta dd { margin: 0; font-weight: 600; font-size: 9pt; }
.fig { display: grid; grid-auto-flow: column; grid-auto-columns: 1fr; padding: 2.4mm 0 2mm; } .fig > div + div { border-left: .25mm solid var(--line); padding-left: 2.6mm; } .fig b { font-size: 16pt; line-height: 1.15; letter-spacing: -.01em; display: block; white-space: nowrap; } .fig small { font-size: 8.6pt; font-weight: 400; color: var(--text-2); letter-spacing: 0; } .fig span { color: var(--text-2); font-size: 7.4pt; line-height: 1.2; display: block; }
.verdict { display: flex; gap: 2.5mm; align-items: center; border: .35mm solid var(--ok); border-radius: 1.2mm; padding: 1.3mm 2.5mm; font-size: 9pt; } .verdict b { color: var(--ok); } .verdict.warn { border-color: #e0a030; background: #fdf3de; } .verdict.warn b { color: var(--warn); } .verdict.warn .ok { stroke: var(--warn); } .verdict.bad { border-color: var(--bad); background: #fdecea; } .verdict.bad b { color: var(--bad); } .verdict.bad .ok { stroke: var(--bad); } .ok { width: 4.2mm; height: 4.2mm; fill: none; stroke: var(--ok); stroke-width: 2.2; stroke-linecap: round; stroke-linejoin: round; }

/* picture and layers */
.hero { display: grid; grid-template-columns: 1fr 50mm; gap: 3mm; margin: 3mm 0 2mm; flex: none; } .hero figure { min-width: 0; min-height: 0; display: flex; flex-direction: column; align-items: center; } .hero figcaption, .hero aside p { color: var(--text-2); font-size: 7.6pt; align-self: flex-start; }
.pic { flex: 1; min-height: 0; width: 100%; } .pic .bar { stroke: var(--text); } .pic .ax { fill: var(--text-2); text-anchor: middle; } .pic .zar { fill: none; stroke: var(--text); stroke-linejoin: round; }
.no { font-weight: 700; text-anchor: middle; fill: #11151a; stroke: #fff; stroke-width: .22em; paint-order: stroke; stroke-linejoin: round; } .no.thin { font-weight: 400; fill: #4a5360; }
.lay { width: 100%; } .lay .area { fill: var(--plot); } .lay .grid { stroke: var(--line); stroke-width: .2; } .lay .axm { font-size: 3.1px; fill: var(--text-2); } .lay .cut { stroke: var(--accent); stroke-width: .3; stroke-dasharray: 1.2 1; } .lay .top { stroke: var(--text); stroke-width: .35; } .lbx { fill: #fff; stroke: var(--accent); stroke-width: .35; } .lbl { font-weight: 700; fill: var(--accent); }

/* left over, signing */
.left { border-top: .35mm solid var(--text); padding-top: 1.6mm; } .left td { padding: .8mm 1.4mm; border-top: .25mm solid var(--line); vertical-align: middle; } .left tr:first-child td { border-top: 0; } .left .tm { width: 15mm; padding-left: 0; } .left .tm img { width: 13mm; height: 9mm; object-fit: contain; } .left .pn { width: 56mm; max-width: 56mm; } .left .n { width: 18mm; } .left tr { height: 10.6mm; } .left .why { overflow-wrap: anywhere; } .left .more { color: var(--text-2); font-size: 8pt; }
.pn b, .pn span { display: block; overflow: hidden; white-space: nowrap; text-overflow: ellipsis; } .pn span { color: var(--text-2); font-size: 7.4pt; }
.sign { display: grid; grid-template-columns: 1fr 1fr 1fr 1.6fr; gap: 4mm; margin-top: auto; padding-top: 2mm; color: var(--text-2); font-size: 8pt; } .sign i { display: block; height: 7mm; border-bottom: .3mm solid var(--line-2); }

/* part list */
.parts { table-layout: fixed; } .parts td { padding: 0 1.4mm; border-bottom: .25mm solid var(--line); vertical-align: middle; } .parts .ck { width: 9mm; padding-left: 0; } .parts td.ck i { display: block; width: 4.6mm; height: 4.6mm; border: .35mm solid var(--line-2); border-radius: .8mm; } .parts .cn { width: 30mm; } .parts .cn div { display: flex; align-items: center; gap: 2mm; } .parts .cn i { width: 4.6mm; height: 7.6mm; border-radius: .8mm; border: .2mm solid #0003; flex: none; } .parts .cn b { font-size: 10.5pt; line-height: 1.1; } .parts .cn b.long { font-size: 8pt; line-height: 1.2; } .parts .ct { width: 21mm; } .parts th.rest { width: 22mm; } .parts .or { width: 17mm; overflow: hidden; text-overflow: ellipsis; } .parts .du { width: 14mm; } .parts .vo { width: 16mm; } .parts .tm { width: 17mm; } .parts .tm img { width: 15mm; height: 10.4mm; object-fit: contain; } .parts td.pn b { font-size: 10pt; } .parts .n { text-align: right; white-space: nowrap; } .parts td.n b { font-size: 10.5pt; } .parts .rest { color: var(--text-2); font-size: 7.8pt; white-space: nowrap; line-height: 1.2; } .parts .none { color: var(--text-2); } .parts .none img { opacity: .55; } .parts .none .ck i { visibility: hidden; } .parts .or, .parts .du { white-space: nowrap; }

/* top views; beside each the numbers to take out of it */
.maps { display: grid; grid-template-columns: 1fr 1fr; gap: 1.6mm 6mm; } .maps.wide { grid-template-columns: 1fr; } .slab { min-width: 0; } .slab figcaption { display: flex; gap: 2mm; align-items: baseline; height: 5.6mm; line-height: 1.1; } .slab figcaption b { font-size: 12pt; color: var(--accent); } .slab figcaption em { margin-left: auto; font-style: normal; color: var(--text-2); font-size: 7.6pt; } .sm { display: grid; gap: 1mm; } .map .grid { stroke: #7d8792; stroke-width: .1; opacity: .45; } .map .wall { fill: none; stroke: #3b434e; stroke-width: .28; } .map .axm { font-size: 2.4px; fill: var(--text-2); } .map .sc { fill: none; stroke: var(--text); stroke-width: .3; }
.take { display: grid; grid-auto-rows: 5.1mm; align-content: start; font-size: 8.4pt; font-weight: 600; } .take span { display: flex; align-items: center; gap: .8mm; } .take i { width: 2mm; height: 3.6mm; border-radius: .4mm; border: .2mm solid #0003; flex: none; } .take em { font-style: normal; font-weight: 400; font-size: 6.6pt; line-height: 1.1; color: var(--text-2); align-self: end; grid-column: 1 / -1; } .take.under { grid-auto-rows: 4.4mm; font-size: 8pt; }

/* removal order */
.sec { margin: 4mm 0 1.5mm; font-size: 11pt; } .key { display: flex; gap: 4mm; align-items: center; font-size: 8pt; margin-bottom: 2.4mm; } .key span { display: flex; gap: 1mm; align-items: center; white-space: nowrap; } .key .x { color: var(--text-2); margin-left: auto; white-space: normal; text-align: right; max-width: 78mm; line-height: 1.2; }
.arrow { width: 3.2mm; height: 3.2mm; fill: none; stroke: currentColor; stroke-width: 1.8; stroke-linecap: round; stroke-linejoin: round; display: inline-block; vertical-align: -.55mm; margin-right: .6mm; flex: none; }
.cols { display: grid; gap: 5mm; align-items: start; } .cols.c3 { grid-template-columns: repeat(3, minmax(0, 1fr)); } .cols.c2 { grid-template-columns: repeat(2, minmax(0, 1fr)); }
.rem { table-layout: fixed; } .rem td { height: 6.3mm; line-height: 1.15; padding: 0 .8mm; border-bottom: .25mm solid var(--line); vertical-align: middle; white-space: nowrap; } .rem th { padding: 0 .8mm .8mm; white-space: nowrap; } .rem .st { width: 8mm; padding-left: 0; color: var(--text-2); } .rem td.nu { font-weight: 600; font-size: 9.6pt; } .rem .nu { width: var(--nu); } .rem .nu i { display: inline-block; width: 2.4mm; height: 4.2mm; border-radius: .5mm; vertical-align: -.7mm; margin-right: 1mm; border: .2mm solid #0003; } .rem .nm { overflow: hidden; text-overflow: ellipsis; } .rem td.nm { font-size: 7.6pt; } .rem .sl { width: 6mm; } .rem td.sl { color: var(--accent); font-weight: 600; } .rem .mv { width: 13mm; text-align: right; padding-right: 0; } .rem td.mv { font-size: 8.6pt; } .rem .fr { color: var(--text-2); } .rem .many td { border-bottom: 0; } .rem .nb td { height: 4.6mm; } .rem .mm { text-align: right; padding-right: 0; font-size: 8pt; color: var(--text-2); } .rem .mm span { margin-left: 1.6mm; color: var(--text); } .rem .g td:first-child { border-left: .45mm solid var(--text); padding-left: .8mm; } .rem .g td:last-child { border-right: .45mm solid var(--text); padding-right: .8mm; } .rem .g1 td { border-top: .45mm solid var(--text); border-bottom: 0; } .rem .g9 td { border-bottom: .45mm solid var(--text); }
.rem.lo .pt { width: 34mm; } .rem.lo .ct { width: 16mm; } .rem.lo td { height: 5.6mm; font-size: 8pt; } .rem.lo td.wy { white-space: normal; overflow-wrap: anywhere; }
.notes { margin-bottom: 3mm; background: repeating-linear-gradient(#fff 0 8.6mm, var(--line) 8.6mm 8.85mm); } .notes h2 { background: #fff; margin: 0; } .notes.rest { flex: 1; min-height: 0; margin-top: 6mm; overflow: hidden; }
.stages { display: grid; grid-template-columns: repeat(4, 1fr); gap: 3mm; margin-top: auto; padding-top: 3mm; } .stages svg { height: var(--h); max-width: 100%; margin: 0 auto; } .stages figcaption { text-align: center; font-size: 8pt; color: var(--text-2); } .stages figcaption b { color: var(--text); } .stages + .foot { margin-top: 0; }

@media screen { html { background: #e2e5ea; } body { padding: 8mm 0; } .page { background: #fff; width: 210mm; height: 297mm; padding: 10mm 10mm 10mm 16mm; margin: 0 auto 8mm; box-shadow: 0 1px 2px rgba(16,24,40,.06), 0 8px 24px rgba(16,24,40,.12); } }
)css";

}  // namespace

std::string sheet_style() { return kStyle; }

}  // namespace spectralpack
