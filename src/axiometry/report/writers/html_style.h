// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The style sheet of the HTML report: a sheet of paper on the screen, A4 in print.
namespace axiometry::report {

inline constexpr std::string_view html_style = R"css(
:root{--ink:#16191d;--quiet:#5d6670;--rule:#c8cdd3;--hair:#e3e6ea;--accent:#1d3c5e;--paper:#fff;
--good:#1c6238;--good-bg:#f1f7f3;--caution:#7d5200;--caution-bg:#fdf8ec;--bad:#9a1b1b;--bad-bg:#fcf3f2}
*{box-sizing:border-box}
html{color-scheme:light;-webkit-text-size-adjust:100%;text-size-adjust:100%}
body{margin:0;background:#eceef1;color:var(--ink);
font:15px/1.5 Arial,"Liberation Sans","Helvetica Neue",Helvetica,sans-serif;
font-variant-numeric:tabular-nums lining-nums}
.sheet{max-width:1000px;margin:2rem auto;padding:3rem 3.5rem 2.5rem;background:var(--paper);
border-top:4px solid var(--accent);
box-shadow:0 1px 3px rgba(20,30,40,.14)}
p{margin:.4rem 0}
.kicker{margin:0;color:var(--accent);font-size:.8rem;font-weight:bold;letter-spacing:.08em;text-transform:uppercase}
h1{margin:.35rem 0 1.4rem;font-size:1.75rem;line-height:1.2;letter-spacing:-.01em}
h2{margin:2.8rem 0 .9rem;padding-bottom:.35rem;border-bottom:1.5px solid var(--accent);color:var(--accent);
font-size:1.15rem;
line-height:1.3;break-after:avoid}
h3{margin:0 0 .3rem;font-size:.92rem;line-height:1.35;break-after:avoid}
.label{float:right;margin:.15rem 0 0 1rem;color:var(--caution);font-size:.8rem;line-height:1.6}
dl{margin:0}
dt{color:var(--quiet)}
dd{margin:0}
dd,td,h1,.notice{overflow-wrap:anywhere;unicode-bidi:isolate}
:lang(de) dt,:lang(de) dd,:lang(de) td,:lang(de) th{hyphens:auto;overflow-wrap:break-word}
dd,.long{white-space:pre-line}
.identity{display:grid;grid-template-columns:repeat(auto-fit,minmax(8.5rem,1fr));gap:.9rem 1.2rem;padding:.9rem 0;
border:solid var(--rule);border-width:1px 0}
.identity dt{font-size:.78rem}
.identity dd{font-weight:bold}
.identity dd.quiet{font-weight:normal}
.notice{margin:1rem 0;padding:.7rem 1rem;border-left:4px solid var(--rule);background:#f6f7f8;break-inside:avoid}
.notice p{margin:0}
.notice .lead{font-weight:bold}
.notice ul{margin:.3rem 0 0;padding-left:1.1rem;font-size:.92em}
.notice.good{border-color:var(--good);background:var(--good-bg)}
.notice.good .lead,td.good{color:var(--good)}
.notice.caution{border-color:var(--caution);background:var(--caution-bg)}
.notice.caution .lead,th.caution,td.caution{color:var(--caution)}
.notice.bad{border-color:var(--bad);background:var(--bad-bg)}
.notice.bad .lead,th.bad,td.bad{color:var(--bad)}
.quiet{color:var(--quiet)}
.columns{columns:2 24rem;column-gap:2.5rem}
.facts{break-inside:avoid-column;margin:0 0 1.5rem}
.facts div{display:grid;grid-template-columns:minmax(8rem,11.5rem) 1fr;gap:0 1rem;padding:.22rem 0;
border-bottom:1px solid var(--hair);
break-inside:avoid;font-size:.9rem}
.scroll{overflow-x:auto;margin:1rem 0 1.5rem}
.scroll:has(+.notes){margin-bottom:.4rem}
table{width:100%;border-collapse:collapse;border-bottom:1.5px solid var(--ink);font-size:.9rem;line-height:1.4}
caption.unseen{position:absolute;width:1px;height:1px;padding:0;overflow:hidden;clip-path:inset(50%)}
caption{padding:0 0 .45rem;text-align:left;font-weight:bold;break-after:avoid}
th,td{padding:.3rem .55rem;text-align:left;vertical-align:baseline;white-space:nowrap}
th:first-child,td:first-child{padding-left:0}
th:last-child,td:last-child{padding-right:0}
thead th{border-bottom:1px solid var(--ink);color:var(--ink);vertical-align:bottom}
thead tr:first-child th{border-top:1.5px solid var(--ink)}
thead .group{border-bottom:0;text-align:center;color:var(--accent)}
thead .group.ruled{background:linear-gradient(var(--rule),var(--rule)) bottom center/calc(100% - .8em) 1px no-repeat}
tbody tr+tr>*{border-top:1px solid var(--hair)}
tbody th{font-weight:normal}
.number{text-align:right}
.number[data-pad]::after{content:attr(data-pad);visibility:hidden}
.centre{text-align:center}
.long{min-width:10rem;white-space:pre-line}
.opens{padding-left:1.2rem}
.dense{font-size:.78rem;line-height:1.3}
.dense caption{font-size:.9rem}
.dense th,.dense td{padding:.22rem .35rem}
.dense .opens{padding-left:.9rem}
.dense tbody tr:nth-child(5n)>*{border-bottom:1px solid var(--rule)}
.dense tbody th{position:sticky;left:0;background:var(--paper)}
.notes{margin:0 0 1.4rem;color:var(--quiet);font-size:.82rem}
.notes p{margin:.15rem 0}
figure{margin:1.2rem 0 2rem;break-inside:avoid}
figure .scroll{margin:0}
figure svg{display:block;width:100%;min-width:38rem;height:auto}
figcaption{margin-top:.5rem;font-size:.9rem;font-weight:bold}
.bar{position:relative;display:inline-block;line-height:1}
.bar::before{content:"";position:absolute;left:.1em;right:-.02em;top:.2em;border-top:.075em solid}
.bar.tall::before{top:-.02em}
sub,sup{font-size:.72em;line-height:0}
footer{margin-top:3rem;padding-top:.6rem;border-top:1px solid var(--rule);color:var(--quiet);font-size:.8rem}
@media screen and (max-width:56rem){
.sheet{margin:1rem auto;padding:2rem 1.8rem}
th,td{padding:.3rem .4rem}
}
@media screen and (max-width:40rem){
body{background:var(--paper)}
.sheet{margin:0;padding:1.4rem 1rem 2rem;box-shadow:none}
h1{font-size:1.4rem}
h2{margin-top:2.2rem}
.label{float:none;display:block;margin:.1rem 0 0}
.identity{grid-template-columns:1fr 1fr}
.facts div{grid-template-columns:8.5rem 1fr}
.long{min-width:8rem}
th,td{padding:.3rem .4rem}
tbody th:not(.long){position:sticky;left:0;background:var(--paper)}
}
@media print{
html{font-size:12px;-webkit-print-color-adjust:exact;print-color-adjust:exact}
body{background:none;font-size:9.5pt;line-height:1.4}
.sheet{max-width:none;margin:0;padding:0;border:0;box-shadow:none}
h1{margin:.1rem 0 .7rem;font-size:17pt}
h2{margin:1.3rem 0 .5rem;font-size:12pt}
.columns{columns:2;column-gap:1.6rem}
.facts{margin-bottom:1rem}
.facts div{grid-template-columns:minmax(8rem,12.5rem) 1fr;font-size:8.5pt}
table{font-size:8.5pt}
th,td{padding:.2rem .5rem}
.notice{margin:.6rem 0;padding:.45rem .8rem}
.identity{padding:.6rem 0}
.scroll{overflow:visible;margin:.5rem 0 .8rem}
.whole,.notes{break-inside:avoid}
.scroll:has(+.notes){margin-bottom:.3rem;break-after:avoid}
thead{display:table-header-group}
tr{break-inside:avoid}
.dense{font-size:min(7.5pt,calc(180mm / (var(--chars) * .6)))}
.dense caption{font-size:8.5pt}
.dense th,.dense td{padding:.2em .3em}
.dense .opens{padding-left:.8em}
.dense tbody th{position:static}
.long{min-width:0}
figure{margin:.6rem 0 .9rem}
figure svg{min-width:0}
figure:first-of-type svg{width:84%;margin:auto}
footer{display:none}
}
)css";

}  // namespace axiometry::report
