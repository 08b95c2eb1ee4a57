// Compares two pictures of the report: one over the other, with a wipe between them; a pixel of a table is shown in both. Without this script
// all pictures are in the gallery.
(function () {
  "use strict";
  const figures = Array.from(document.querySelectorAll("figure.ray"));
  const compare = document.getElementById("compare");
  if (!compare || figures.length < 2) return;
  const part = (name) => compare.querySelector("[data-part=" + name + "]");
  const stage = part("stage"), wipe = part("wipe");
  const sides = { a: null, b: null };

  // A side shows a figure: picture, legend, name, and the choice in its list.
  function show(side, figure) {
    sides[side] = figure;
    const picture = figure.querySelector("img.picture"), legend = figure.querySelector(".legend");
    part("picture-" + side).src = picture.src;
    part("picture-" + side).alt = picture.alt;
    part("legend-" + side).replaceChildren(...legend.cloneNode(true).childNodes);
    part("name-" + side).textContent = figure.dataset.title;
    compare.style.setProperty("--aspect", String(picture.getAttribute("width") / picture.getAttribute("height")));
    part("choice-" + side).value = figure.id;
    for (const one of figures) {
      one.classList.toggle("is-" + side, one === figure);
      const button = one.querySelector("button[data-side=" + side + "]");
      if (button) button.setAttribute("aria-pressed", String(one === figure));
    }
  }

  function setWipe(share) {
    wipe.value = String(Math.round(Math.min(Math.max(share, 0), 1) * 1000));
    stage.style.setProperty("--wipe", wipe.value / 10 + "%");
  }

  function flip() {
    const a = sides.a;
    show("a", sides.b);
    show("b", a);
  }

  function wipeTo(event) {
    const box = stage.getBoundingClientRect();
    setWipe((event.clientX - box.left) / box.width);
  }

  // The pixel of the frame under the pointer.
  const size = (name) => Number(figures[0].querySelector("img.picture").getAttribute(name));
  function pixelAt(event) {
    const box = stage.getBoundingClientRect();
    const along = (at, length, count) => Math.min(Math.max(Math.floor((at / length) * count), 0), count - 1);
    return along(event.clientX - box.left, box.width, size("width")) + "," + along(event.clientY - box.top, box.height, size("height"));
  }

  // A ring around a pixel.
  function markPixel(text) {
    const [x, y] = text.split(",").map(Number), mark = part("mark");
    mark.style.left = (100 * (x + 0.5)) / size("width") + "%";
    mark.style.top = (100 * (y + 0.5)) / size("height") + "%";
    mark.hidden = false;
    part("pixel").textContent = "pixel " + text;
    compare.scrollIntoView({ block: "nearest" });
  }

  for (const cell of document.querySelectorAll("td[data-pixel]")) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "go";
    button.textContent = cell.textContent;
    button.title = "Show this pixel in the pictures";
    button.addEventListener("click", () => markPixel(cell.dataset.pixel));
    cell.replaceChildren(button);
  }

  for (const figure of figures) {
    const pick = document.createElement("span");
    pick.className = "pick";
    for (const side of ["a", "b"]) {
      const option = document.createElement("option");
      option.value = figure.id;
      option.textContent = figure.dataset.title;
      part("choice-" + side).append(option);

      const button = document.createElement("button");
      button.type = "button";
      button.dataset.side = side;
      button.textContent = side === "a" ? "Show left" : "Show right";
      button.addEventListener("click", () => show(side, figure));
      pick.append(button);
    }
    figure.querySelector("figcaption").append(pick);
    figure.querySelector("img.picture").addEventListener("click", () => {
      show("b", figure);
      compare.scrollIntoView({ block: "nearest" });
    });
  }

  for (const side of ["a", "b"])
    part("choice-" + side).addEventListener("change", (event) => show(side, document.getElementById(event.target.value)));
  wipe.addEventListener("input", () => setWipe(wipe.value / 1000));
  part("flip").addEventListener("click", flip);
  stage.addEventListener("pointerdown", (event) => {
    stage.setPointerCapture(event.pointerId);
    wipeTo(event);
  });
  stage.addEventListener("pointermove", (event) => {
    if (stage.hasPointerCapture(event.pointerId)) wipeTo(event);
    part("pixel").textContent = "pixel " + pixelAt(event);
  });
  document.addEventListener("keydown", (event) => {
    if (event.target.closest("a, button, select, input") || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "x") flip();
    else if (event.key === "[") setWipe(wipe.value / 1000 - 0.05);
    else if (event.key === "]") setWipe(wipe.value / 1000 + 0.05);
  });

  document.documentElement.classList.add("js");
  compare.hidden = false;
  show("a", document.getElementById("view-final") || figures[0]);
  show("b", document.getElementById("view-verdict") || figures[1]);
  setWipe(0.5);
})();

// Sorts a table by the column whose head is clicked: numbers first the largest, then the other way round.
(function () {
  "use strict";
  const valueOf = (row, column) => {
    const text = row.cells[column].textContent.trim();
    const number = parseFloat(text.replace(/,/g, ""));
    return { text, number: /^[-+]?[\d.]/.test(text) ? number : NaN };
  };

  function compare(a, b) {
    if (Number.isNaN(a.number) !== Number.isNaN(b.number)) return Number.isNaN(a.number) ? -1 : 1;
    return Number.isNaN(a.number) ? b.text.localeCompare(a.text) : a.number - b.number;
  }

  for (const table of document.querySelectorAll("table.sortable")) {
    const heads = Array.from(table.tHead.rows[0].cells);
    heads.forEach((head, column) => {
      if (!head.textContent) return;
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = head.textContent;
      head.replaceChildren(button);
      button.addEventListener("click", () => {
        const down = head.getAttribute("aria-sort") !== "descending";
        for (const other of heads) other.removeAttribute("aria-sort");
        head.setAttribute("aria-sort", down ? "descending" : "ascending");
        const rows = Array.from(table.tBodies[0].rows);
        rows.sort((a, b) => (down ? -1 : 1) * compare(valueOf(a, column), valueOf(b, column)));
        const isSum = (row) => row.classList.contains("changed");
        table.tBodies[0].append(...rows.filter((row) => !isSum(row)), ...rows.filter(isSum));
      });
    });
  }
})();

// The link of the section that is being read.
(function () {
  "use strict";
  const links = new Map(Array.from(document.querySelectorAll("nav a"), (link) => [link.hash.slice(1), link]));
  if (!("IntersectionObserver" in window)) return;
  const seen = new IntersectionObserver(
    (entries) => {
      for (const entry of entries)
        if (entry.isIntersecting) {
          for (const link of links.values()) link.classList.remove("here");
          links.get(entry.target.id).classList.add("here");
        }
    },
    { rootMargin: "-60px 0px -70% 0px" }
  );
  for (const id of links.keys()) seen.observe(document.getElementById(id));
})();
