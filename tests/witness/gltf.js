// The glTF validator of the Khronos Group on files: it must have nothing to say, not even a hint.
const fs = require("fs");
const validator = require("gltf-validator");

async function main() {
    let failed = 0;
    for (const file of process.argv.slice(2)) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { uri: file });
        for (const issue of report.issues.messages) console.log(file, issue.code, issue.pointer, issue.message);
        const ok = report.issues.messages.length === 0;
        failed += !ok;
        console.log(`gltf: ${file} ${report.info.totalTriangleCount} triangles, ${report.info.totalVertexCount} vertices`,
            ok ? "" : "FAILED");
    }
    console.log(`WITNESS ${process.argv.length - 2} files, ${failed} failed`);
    process.exit(failed || process.argv.length < 4 ? 1 : 0);
}

main();
