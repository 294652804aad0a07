export const previewSteps = [];
