// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The curves, by Dygraphs. All of them show the same part of the time; a section that is closed
// draws its curves when it is opened, because they need a place with a size.
(function () {
  "use strict";
  const sections = JSON.parse(document.getElementById("curve-data").textContent);
  // Okabe and Ito's palette: distinguishable with any kind of colour vision.
  const colours = ["#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#222222",
                   "#8A8A8A"];
  const graphs = [];
  const number = value => (value === 0 ? "0" : String(+value.toPrecision(5)));
  let busy = false, shown = null;

  function zoomAll(low, high) {
    if (busy) return;
    busy = true;
    shown = [low, high];
    for (const graph of graphs) graph.updateOptions({ dateWindow: shown, valueRange: null });
    busy = false;
  }

  function resetAll() {
    busy = true;
    shown = null;
    for (const graph of graphs) graph.updateOptions({ dateWindow: null, valueRange: null });
    busy = false;
  }

  function draw(chart, place) {
    const box = document.createElement("figure");
    const title = document.createElement("figcaption");
    const area = document.createElement("div");
    const legend = document.createElement("div");
    title.textContent = chart.title + (chart.note ? ` (${chart.note})` : "");
    legend.className = "legend";
    area.className = "curve";
    box.append(title, area, legend);
    place.append(box);
    const graph = new Dygraph(area, chart.rows, {
      labels: chart.labels,
      colors: colours,
      legend: "always",
      labelsDiv: legend,
      xlabel: "time",
      strokeWidth: 1.6,
      drawPoints: chart.rows.length < 12,
      stepPlot: chart.stepped,
      yRangePad: 8,
      dateWindow: shown,
      axes: {
        x: { drawGrid: true, valueFormatter: number, axisLabelFormatter: number },
        y: { axisLabelWidth: 70, valueFormatter: number, axisLabelFormatter: number },
      },
      zoomCallback: (low, high) => {
        if (!graph.isZoomed()) resetAll();
        else if (graph.isZoomed("x") && (!shown || low !== shown[0] || high !== shown[1]))
          zoomAll(low, high);
      },
    });
    graphs.push(graph);
  }

  document.querySelectorAll("details[data-curves]").forEach(details => {
    const fill = () => {
      if (!details.open || details.dataset.drawn) return;
      details.dataset.drawn = "yes";
      const place = details.querySelector(".curves");
      if (typeof Dygraph === "undefined") place.textContent = place.dataset.missing;
      else for (const chart of sections[+details.dataset.curves].charts) draw(chart, place);
    };
    details.addEventListener("toggle", fill);
    fill();
  });
})();
