// The page in a browser: made by the program from real results, opened from disk, offline. All tests in one process, which
// makes the results and starts the browser once.
// Environment: MMVERIFY_PROGRAM, CHROMIUM; MMVERIFY_SHOTS: a folder for pictures of it.
import "./page/sections";
import "./page/verdicts";
import "./page/charts";
import "./page/triangle";
import "./page/attributes";
import "./page/rays";
import "./page/access";
import "./page/hostile";
