// The page in a browser: opened from disk, offline. All tests in one process, which starts the browser once.
// Environment: MMVERIFY_PAGE, MMVERIFY_PROGRAM (the native one, to make scenes), CHROMIUM; MMVERIFY_SHOTS: a folder for
// pictures of it.
import "./page/start";
import "./page/scene";
import "./page/function";
import "./page/files";
import "./page/laws";
import "./page/walk";
import "./page/access";
