// Khronos's validator over files: node validate.cjs FILE...
// A line per error and warning, a line of sums per file.  Exit code 1 where a file has an error.
const fs = require("fs");
const path = require("path");
const validator = require("gltf-validator");

const severities = ["error", "warning"];

async function validate(file) {
  const folder = path.dirname(file);
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
    uri: path.basename(file),
    maxIssues: 0, // all
    externalResourceFunction: (uri) => fs.promises.readFile(path.resolve(folder, decodeURIComponent(uri))),
  });
  for (const issue of report.issues.messages) {
    if (issue.severity < severities.length) {
      console.log(`${file}: ${severities[issue.severity]} ${issue.code}: ${issue.pointer ?? issue.offset}: ${issue.message}`);
    }
  }
  const { numErrors, numWarnings, numInfos, numHints } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`);
  return numErrors;
}

async function main(files) {
  console.log(`gltf-validator ${validator.version()}`);
  let errors = 0;
  for (const file of files) {
    try {
      errors += await validate(file);
    } catch (error) {
      console.log(`${file}: error: ${error.message ?? error}`); // no glTF at all
      errors += 1;
    }
  }
  process.exit(errors === 0 ? 0 : 1);
}

main(process.argv.slice(2));
