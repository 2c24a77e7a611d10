"use strict";
// The report of a run is a view of its page: what it says without scripts, beside the run to walk through.
(() => {
  const section = document.getElementById("report");
  if (!section) return;
  const view = H.views.report = {}, dress = reading => {
    document.getElementById("of-report").media = reading ? "all" : "not all";
    document.getElementById("of-page").media = reading ? "not all" : "all";
    section.hidden = !reading;
    document.getElementById("main").hidden = reading;
    document.querySelector("footer").hidden = reading;
    document.body.classList.toggle("reading", reading);
  };
  document.querySelector("header").hidden = false;
  view.open = () => dress(true);
  view.close = () => dress(false);
  view.update = async () => { const opened = await H.opened, name = opened.runs[0].name; H.command({shell: `hugoniot report ${H.shell(name)}`, python: `from hugoniot.report import write_report\nprint(write_report(${H.python(name)}))`}); };
})();
